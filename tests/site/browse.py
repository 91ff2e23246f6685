"""Read the book in a browser: python3 tests/site/browse.py FOLDER

Every page of FOLDER is opened in Chromium on a phone and on a desktop, in
light and in dark, straight from the disk.  All films have the same script, and
to play them takes long: those of a page are played on one of the two, in turn.
"""
import json
import re
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from urllib.parse import unquote, urldefrag, urlparse

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

WIDTHS = {"phone": (390, 844), "desktop": (1400, 900)}
TERM = "worldline"
NAME = "tf_point_triangle"
ENTRY = "reference.html#c." + NAME
FILMS_WEIGHT = 3_000_000    # bytes, of all films of a chapter in one theme

LOOK = r"""
const shown = e => e.checkVisibility() && e.getClientRects().length > 0;
const images = [...document.images];
for (const image of images) image.loading = 'eager';
const wide = [...document.querySelectorAll('.equation, .code-box pre')];
const paper = getComputedStyle(document.body).backgroundColor;
const words = document.querySelector('main').cloneNode(true);
for (const code of words.querySelectorAll('pre, code, .sig')) code.remove();
scrollTo(0, 400);
const bar = document.querySelector('.bar').getBoundingClientRect();
scrollTo(0, 0);
return {
  title: document.title,
  tex: words.textContent.match(/\\[A-Za-z]+/)?.[0],
  bar: bar.top,
  clipped: images.filter(i => shown(i) && (
    i.getBoundingClientRect().left < -1 || i.getBoundingClientRect().right >
    document.documentElement.clientWidth + 1)).map(i => i.src),
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


# How many pixels of two PNG files, in base 64, differ so that it can be seen.
DIFFERENCE = r"""
const [first, second, done] = arguments;
const pixels = async text => {
  const image = new Image();
  image.src = 'data:image/png;base64,' + text;
  await image.decode();
  const canvas = new OffscreenCanvas(image.width, image.height);
  const context = canvas.getContext('2d');
  context.drawImage(image, 0, 0);
  return context.getImageData(0, 0, image.width, image.height).data;
};
Promise.all([pixels(first), pixels(second)]).then(([a, b]) => done(
  a.length === b.length ? a.filter((x, i) => Math.abs(x - b[i]) > 32).length
                        : Infinity));"""
SEEN = 30


def browser():
    options = webdriver.ChromeOptions()
    for argument in "headless=new", "no-sandbox", "disable-dev-shm-usage":
        options.add_argument("--" + argument)
    options.set_capability("goog:loggingPrefs",
                           {"browser": "ALL", "performance": "ALL"})
    return webdriver.Chrome(service=Service("/usr/bin/chromedriver"),
                            options=options)


def wait(condition):
    """Whether a condition comes true; a busy machine takes its time."""
    for _ in range(600):
        if condition():
            return True
        time.sleep(0.05)
    return False


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
    wait(lambda: chromium.execute_script(
        "return [...document.images].filter(i => i.checkVisibility())"
        ".every(i => i.complete)"))


def faults_of_look(look, device, theme):
    """What is wrong with a page as it was seen."""
    if look["width"] > WIDTHS[device][0]:
        yield f"is {look['width']} pixels wide, see {look['beyond']}"
    if (sum(look["paper"][:3]) < 384) != (theme == "dark"):
        yield f"has paper {look['paper']}"
    if re.match(r"(\S+) \1 ", look["title"]):
        yield f"has its number twice in its title, {look['title']}"
    if look["tex"]:
        yield f"shows TeX, {look['tex']}"
    if look["bar"] != 0:
        yield f"has a bar that scrolls away, to {look['bar']}"
    for source in look["clipped"]:
        yield f"shows a part of {source} only"
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


def search(chromium, folder, words):
    chromium.get((folder / "index.html").as_uri())
    chromium.find_element(By.CSS_SELECTOR, ".find input").send_keys(
        words + Keys.ENTER)
    wait(lambda: chromium.find_elements(By.CSS_SELECTOR, "#results a"))
    return chromium.find_elements(By.CSS_SELECTOR, "#results a")


def faults_of_search(chromium, folder):
    found = search(chromium, folder, TERM)
    if not found:
        yield f"the search does not find '{TERM}'"
        return
    chapters = chromium.find_elements(By.CLASS_NAME, "home-page")
    if not chapters or not all(chapter.text for chapter in chapters):
        yield "the search does not name the chapters of what it finds"
    found[0].click()
    if TERM not in chromium.find_element(By.TAG_NAME, "main").text.lower():
        yield f"the search leads to where '{TERM}' is not"


def faults_of_reference(chromium, folder):
    """A search for a public name leads to its entry."""
    found = search(chromium, folder, NAME)
    if not found or not found[0].get_attribute("href").endswith(ENTRY):
        yield f"'{NAME}' is not the first result of a search for it"
        return
    found[0].click()
    entry = chromium.find_element(By.CSS_SELECTOR, ":target")
    if NAME not in entry.text or not entry.is_displayed():
        yield f"the search leads to where '{NAME}' is not declared"


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


def settled(element):
    """A picture of it once the browser has painted and moved everything."""
    seen, picture = None, element.screenshot_as_base64
    for _ in range(100):
        if picture == seen:
            break
        seen, picture = picture, element.screenshot_as_base64
    return picture


class Film:
    """A film of the page that is open."""

    def __init__(self, chromium, figure):
        self.chromium, self.figure = chromium, figure
        self.slider = figure.find_element(By.CSS_SELECTOR, "input")
        self.button = figure.find_element(By.CSS_SELECTOR, "button")
        self.name = figure.get_attribute("id")

    def shown(self, what):
        return any(e.is_displayed()
                   for e in self.figure.find_elements(By.CSS_SELECTOR, what))

    def value(self):
        return int(self.slider.get_property("value"))

    def rests(self):
        before = self.value()
        time.sleep(0.3)
        return self.value() == before

    def press(self, *keys):
        """The picture after some keys on the slider, and the time it names."""
        self.slider.send_keys(*keys)
        wait(lambda: any(
            c.get_attribute("data-frame") == str(self.value())
            for c in self.figure.find_elements(By.TAG_NAME, "canvas")))
        canvas = self.figure.find_element(By.TAG_NAME, "canvas")
        self.chromium.execute_script(       # to the same place each time
            "arguments[0].scrollIntoView({block: 'center'})", canvas)
        return (settled(canvas),
                self.slider.get_attribute("aria-valuetext"))

    def differ(self, first, second):
        """Whether two pictures do; edges of the page leave traces."""
        return self.chromium.execute_async_script(
            DIFFERENCE, first, second) > SEEN

    def tap(self, share):
        """Tap on the slider at a share of its width."""
        box = self.chromium.execute_script(
            "return arguments[0].getBoundingClientRect()", self.slider)
        at = {"x": box["left"] + share * box["width"],
              "y": box["top"] + box["height"] / 2}
        for kind, points in ("touchStart", [at]), ("touchEnd", []):
            self.chromium.execute_cdp_cmd("Input.dispatchTouchEvent", {
                "type": kind, "touchPoints": points})


def comes_back(film):
    """Whether keys lead back to the first frame; a busy browser paints late."""
    begin, _ = film.press(Keys.HOME)
    film.press(*4 * [Keys.ARROW_RIGHT])
    back, _ = film.press(*4 * [Keys.ARROW_LEFT])
    return not film.differ(back, begin)


def faults_of_slider(film):
    """Keys lead to frames, the same ones each time."""
    last = int(film.slider.get_property("max"))
    begin, named = film.press(Keys.HOME)
    if named != "t = 0.00":
        yield f"has {named} after Home"
    later, named = film.press(*4 * [Keys.ARROW_RIGHT])
    if not film.differ(later, begin) or film.value() != 4:
        yield f"shows frame {film.value()} or no other one after four arrows"
    if not any(comes_back(film) for _ in range(3)):
        yield "does not come back to its first frame"
    end, named = film.press(Keys.END)
    if not film.differ(end, later) or (named, film.value()) != ("t = 1.00",
                                                                last):
        yield f"has {named} and frame {film.value()} after End"


def faults_of_play(film):
    """The button and the space bar begin and stop it; nothing else does."""
    last = int(film.slider.get_property("max"))
    for kind, start in (("button", film.button.click),
                        ("space bar", lambda: film.slider.send_keys(" "))):
        film.press(Keys.HOME)
        time.sleep(0.3)
        if film.value() != 0:
            yield "plays unasked"
        start()
        if not wait(lambda: film.value() > 3):
            yield f"does not play by the {kind}"
        start()
        if not wait(film.rests) or film.value() == last:
            yield f"does not stop by the {kind}"
    film.press(Keys.END)
    film.slider.send_keys(Keys.ARROW_LEFT)
    film.button.click()
    if not wait(lambda: film.button.get_attribute("aria-label") ==
                     "Play"):
        yield "does not stop at its end"


def faults_of_still(film, theme):
    """What is seen before the film is used, on paper and without script."""
    if film.shown("canvas") or not film.shown("img.on-" + theme):
        yield "does not begin with its still"


def faults_of_print(chromium, film, theme):
    features = [{"name": "prefers-color-scheme", "value": theme}]
    chromium.execute_cdp_cmd("Emulation.setEmulatedMedia", {
        "media": "print", "features": features})
    if film.shown("canvas, input, button") or not film.shown("img.on-light"):
        yield "is not its still on paper"
    chromium.execute_cdp_cmd("Emulation.setEmulatedMedia", {
        "media": "", "features": features})


def faults_without_script(chromium, page, theme):
    chromium.execute_cdp_cmd("Emulation.setScriptExecutionDisabled",
                             {"value": True})
    chromium.get(page.as_uri())
    for figure in chromium.find_elements(By.CLASS_NAME, "film"):
        film = Film(chromium, figure)
        if film.shown("input, button, canvas") or not film.shown(
                "img.on-" + theme):
            yield f"film {film.name} is not its still without script"
    chromium.execute_cdp_cmd("Emulation.setScriptExecutionDisabled",
                             {"value": False})


def faults_of_sheets(addresses, films, theme):
    """Only the sheets of the theme are loaded, each once."""
    sheets = [Path(unquote(urlparse(a).path)) for a in addresses
              if "/_images/films/" in a]
    if len(sheets) != films or len(set(sheets)) != films or not all(
            s.stem.endswith("-" + theme) for s in sheets):
        yield "loads for its films " + ", ".join(s.name for s in sheets)
    weight = sum(s.stat().st_size for s in sheets)
    if weight > FILMS_WEIGHT:
        yield f"has films of {weight} bytes"


def faults_of_films(chromium, page, device, theme):
    chromium.get_log("performance")
    chromium.get(page.as_uri())
    films = [Film(chromium, figure) for figure in
             chromium.find_elements(By.CLASS_NAME, "film")]
    for film in films:
        chromium.execute_script(    # whose focus ring lies on the picture
            "arguments[0].scrollIntoView({block: 'center'});"
            "arguments[0].style.outline = 'none'", film.slider)
        found = [*faults_of_still(film, theme), *faults_of_slider(film),
                 *faults_of_play(film), *faults_of_print(chromium, film, theme)]
        if device == "phone":
            film.tap(0.9)
            if film.value() < 0.8 * int(film.slider.get_property("max")):
                found.append(f"has frame {film.value()} after a tap")
        for fault in found:
            yield f"film {film.name} {fault}"
    if films:
        yield from faults_of_sheets(requests(chromium), len(films), theme)
        yield from faults_without_script(chromium, page, theme)


def faults_of_device(folder, device):
    """What is wrong on a device, and the last look at each page."""
    pages = sorted(folder.glob("*.html"))
    chromium = browser()
    found, looks = [], {}

    def note(place, faults):
        found.extend(f"{place} {fault}" for fault in faults)

    try:
        for theme in "light", "dark":
            become(chromium, device, theme)
            for page in pages:
                note(f"{page.name} ({device}, {theme})",
                     faults_of_page(chromium, page, device, theme, looks))
        for kind in faults_of_search, faults_of_reference:
            note(f"({device})", kind(chromium, folder))
        theme = "dark" if device == "phone" else "light"
        become(chromium, device, theme)
        for number, page in enumerate(pages):
            note(f"{page.name} ({device})", faults_of_keys(chromium, page))
            if device == "phone":
                note(f"{page.name} ({device})",
                     faults_of_notes(chromium, page))
            if list(WIDTHS)[number % len(WIDTHS)] == device:
                note(f"{page.name} ({device}, {theme})",
                     faults_of_films(chromium, page, device, theme))
    finally:
        chromium.quit()
    return found, looks


def main(folder):
    pages = sorted(folder.glob("*.html"))
    if not pages:
        sys.exit(f"{folder}: no pages here")
    print(f"{len(pages)} pages:", *(page.stem for page in pages))
    with ThreadPoolExecutor() as pool:
        results = list(pool.map(lambda device: faults_of_device(folder, device),
                                WIDTHS))
    found = [fault for faults, _ in results for fault in faults]
    looks = results[0][1]
    found += [f"{page.name} {fault}" for page, fault in faults_of_links(looks)]
    for fault in found:
        print(fault, file=sys.stderr)
    print(f"phone and desktop, light and dark: {len(found)} faults")
    return not found


if __name__ == "__main__":
    sys.exit(0 if main(Path(sys.argv[1]).resolve()) else 1)
