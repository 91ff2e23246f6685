"""Read the book in a browser: python3 tests/site/browse.py FOLDER

Every page of FOLDER is opened in Chromium on a phone and on a desktop, in
light and in dark, straight from the disk.
"""
import json
import sys
import time
from pathlib import Path
from urllib.parse import unquote, urldefrag, urlparse

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

WIDTHS = {"phone": (390, 844), "desktop": (1400, 900)}
TERM = "worldline"

LOOK = r"""
const shown = e => e.checkVisibility() && e.getClientRects().length > 0;
const images = [...document.images];
for (const image of images) image.loading = 'eager';
const wide = [...document.querySelectorAll('.equation, .code-box pre')];
const paper = getComputedStyle(document.body).backgroundColor;
return {
  width: document.documentElement.scrollWidth,
  beyond: [...document.querySelectorAll('main *, header *, footer *')]
    .filter(e => e.getBoundingClientRect().right >
                 document.documentElement.clientWidth + 1)
    .map(e => `<${e.localName}> ${e.textContent.trim().slice(0, 40)}`)[0],
  paper: paper.match(/\d+/g).map(Number),
  ids: [...document.querySelectorAll('[id]')].map(e => e.id),
  links: [...document.links].map(a => a.href),
  broken: images.filter(i => shown(i) && !(i.complete && i.naturalWidth))
    .map(i => i.src),
  silent: images.filter(i => !i.alt).map(i => i.src),
  themes: images.filter(shown).map(i => i.className),
  wide: wide.filter(e => shown(e) && e.scrollWidth > e.clientWidth + 1)
    .map(e => [...e.textContent.trim()].slice(0, 60).join('')),
  headings: document.querySelectorAll('h1').length,
};"""

FOCUS = r"""
const e = document.activeElement, box = e.getBoundingClientRect();
return {name: e.className || e.id || e.tagName,
  seen: box.width > 0 && box.right > 0 && box.left < innerWidth,
  outline: getComputedStyle(e).outlineStyle, end: e === document.body};"""


def browser():
    options = webdriver.ChromeOptions()
    for argument in "headless=new", "no-sandbox", "disable-dev-shm-usage":
        options.add_argument("--" + argument)
    options.set_capability("goog:loggingPrefs",
                           {"browser": "ALL", "performance": "ALL"})
    return webdriver.Chrome(service=Service("/usr/bin/chromedriver"),
                            options=options)


def become(chromium, device, theme):
    width, height = WIDTHS[device]
    chromium.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
        "width": width, "height": height, "deviceScaleFactor": 1,
        "mobile": device == "phone"})
    chromium.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [
        {"name": "prefers-color-scheme", "value": theme}]})


def requests(chromium):
    """The addresses that were asked for since the last call."""
    for entry in chromium.get_log("performance"):
        message = json.loads(entry["message"])["message"]
        if message["method"] == "Network.requestWillBeSent":
            yield message["params"]["request"]["url"]


def settle(chromium):
    """Wait until all pictures are there, or will not come."""
    chromium.execute_script(
        "for (const i of document.images) i.loading = 'eager';")
    for _ in range(50):
        if chromium.execute_script("return [...document.images].filter("
                                   "i => i.checkVisibility())"
                                   ".every(i => i.complete)"):
            return
        time.sleep(0.05)


def faults_of_look(look, device, theme):
    """What is wrong with a page as it was seen."""
    if look["width"] > WIDTHS[device][0]:
        yield f"is {look['width']} pixels wide, see {look['beyond']}"
    if (sum(look["paper"][:3]) < 384) != (theme == "dark"):
        yield f"has paper {look['paper']}"
    if look["headings"] != 1:
        yield f"has {look['headings']} main headings"
    for source in look["broken"]:
        yield f"has a broken picture {source}"
    for source in look["silent"]:
        yield f"has a picture without words: {source}"
    for classes in look["themes"]:
        if "on-" in classes and "on-" + theme not in classes:
            yield f"shows a picture {classes}"
    if device == "desktop":
        for text in look["wide"]:
            yield f"has to be scrolled sideways to read '{text}'"


def faults_of_page(chromium, page, device, theme, looks):
    for kind in "browser", "performance":   # what came of earlier pages
        chromium.get_log(kind)
    chromium.get(page.as_uri())
    settle(chromium)
    look = looks[page] = chromium.execute_script(LOOK)
    yield from faults_of_look(look, device, theme)
    for entry in chromium.get_log("browser"):
        if entry["level"] in ("SEVERE", "WARNING"):
            yield "says on the console: " + entry["message"]
    for address in requests(chromium):
        if urlparse(address).scheme not in ("file", "data"):
            yield "asks for " + address


def faults_of_links(looks):
    """Links to pages or places that are not there."""
    for page, look in looks.items():
        for link in look["links"]:
            address, anchor = urldefrag(link)
            if urlparse(address).scheme != "file":
                continue
            target = Path(unquote(urlparse(address).path))
            if not target.is_file():
                yield page, f"links to {target.name}, which is not there"
            elif anchor and unquote(anchor) not in looks.get(
                    target, {"ids": []})["ids"]:
                yield page, f"links to {target.name}#{anchor}, not there"


def faults_of_search(chromium, folder):
    chromium.get((folder / "index.html").as_uri())
    chromium.find_element(By.CSS_SELECTOR, ".find input").send_keys(
        TERM + Keys.ENTER)
    time.sleep(0.5)
    found = chromium.find_elements(By.CSS_SELECTOR, "#results a")
    if not found:
        yield f"the search does not find '{TERM}'"
        return
    found[0].click()
    if TERM not in chromium.find_element(By.TAG_NAME, "main").text.lower():
        yield f"the search leads to where '{TERM}' is not"


def press(chromium, key):
    chromium.switch_to.active_element.send_keys(key)
    return chromium.execute_script(FOCUS)


def faults_of_keys(chromium, page):
    """The first tab stop leads to the text; each stop can be seen."""
    chromium.get(page.as_uri())
    first = press(chromium, Keys.TAB)
    if first["name"] != "skip" or not first["seen"]:
        yield f"the first tab stop is {first}"
    if press(chromium, Keys.ENTER)["name"] != "text":
        yield "the first tab stop does not lead to the text"
    chromium.get(page.as_uri())
    for _ in range(12):
        stop = press(chromium, Keys.TAB)
        if stop["end"]:
            return
        if not stop["seen"] or stop["outline"] == "none":
            yield f"a tab stop cannot be seen: {stop}"


def faults_of_notes(chromium, page):
    """On a phone a note opens at a tap on its number."""
    chromium.get(page.as_uri())
    for mark in chromium.find_elements(By.CLASS_NAME, "note-mark")[:3]:
        note = mark.find_element(By.XPATH, "following-sibling::span[1]")
        before = note.is_displayed()
        chromium.execute_script("arguments[0].click()", mark)
        if before or not note.is_displayed():
            yield f"note {mark.text} does not open"


def faults(chromium, folder):
    pages = sorted(folder.glob("*.html"))
    print(f"{len(pages)} pages:", *(page.stem for page in pages))
    for device in WIDTHS:
        for theme in "light", "dark":
            become(chromium, device, theme)
            looks = {}
            for page in pages:
                for fault in faults_of_page(chromium, page, device, theme,
                                            looks):
                    yield f"{page.name} ({device}, {theme}) {fault}"
        for fault in faults_of_search(chromium, folder):
            yield f"({device}) {fault}"
        for page in pages:
            for fault in faults_of_keys(chromium, page):
                yield f"{page.name} ({device}) {fault}"
            if device == "phone":
                for fault in faults_of_notes(chromium, page):
                    yield f"{page.name} ({device}) {fault}"
    for page, fault in faults_of_links(looks):
        yield f"{page.name} {fault}"


def main(folder):
    if not list(folder.glob("*.html")):
        sys.exit(f"{folder}: no pages here")
    chromium = browser()
    try:
        found = list(faults(chromium, folder))
    finally:
        chromium.quit()
    for fault in found:
        print(fault, file=sys.stderr)
    print(f"phone and desktop, light and dark: {len(found)} faults")
    return not found


if __name__ == "__main__":
    sys.exit(0 if main(Path(sys.argv[1]).resolve()) else 1)
