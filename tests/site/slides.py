"""Look at the slides in a browser: python3 tests/site/slides.py FOLDER

Every deck of FOLDER is opened in Chromium, straight from the disk, and compared
with the chapters in book/ and with its PDF.
"""
import re
import sys
from pathlib import Path
from urllib.parse import urlparse

from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

import browse

sys.dont_write_bytecode = True
ROOT = Path(__file__).parents[2]
WIDTH, HEIGHT = 1920, 1080
SMALLEST = 24       # pixels, of letters that are read from afar

# What is wrong with the slide that is shown.
LOOK = r"""
const slide = document.querySelector('.slide.current');
const box = e => e.getBoundingClientRect();
const room = box(slide), foot = box(slide.querySelector('.foot'));
const head = slide.querySelector('h2');
const top = head && !slide.matches('.opener') ? box(head).bottom : 0;
const shown = e => e.checkVisibility({visibilityProperty: true})
  && box(e).width > 0;
const parts = [...slide.querySelectorAll('.content, .content *, .deck *')]
  .filter(e => shown(e) && !e.closest('.foot')
            && (!e.closest('math') || e.localName === 'math'));
const words = slide.cloneNode(true);
for (const code of words.querySelectorAll('code, script')) code.remove();
const found = [];
for (const e of parts) {
  const {left, right, top: above, bottom} = box(e);
  if (left < 10 || right > room.right - 10 || above < top - 1
      || bottom > foot.top + 1)
    found.push(`<${e.localName}> does not fit: ` +
               e.textContent.trim().slice(0, 40));
}
if (Math.abs(room.width / room.height - 16 / 9) > 0.01 ||
    room.width < innerWidth - 1)
  found.push(`is ${room.width} x ${room.height}`);
if (/\\[A-Za-z]+/.test(words.textContent) || slide.querySelector('merror'))
  found.push('shows TeX');
for (const e of slide.querySelectorAll('.content p, .content li'))
  if (parseFloat(getComputedStyle(e).fontSize) < arguments[0])
    found.push('has letters that are too small');
for (const image of slide.querySelectorAll('img')) {
  if (!image.complete || !image.naturalWidth) found.push('misses ' + image.src);
  if (!shown(image)) found.push('hides ' + image.src);
}
if (getComputedStyle(slide).backgroundColor.match(/\d+/g).slice(0, 3)
    .some(part => part < 240)) found.push('is not light');
return found.slice(0, 3);"""

SLIDES = r"""
return [...document.querySelectorAll('.slide')].map(slide => ({
  id: slide.id, kind: slide.className,
  alt: slide.querySelector('figure img')?.alt}));"""


def chapters():
    """The texts of the chapters, those of each part in a list."""
    parts = []
    for line in (ROOT / "book/chapters").read_text().splitlines():
        if line.startswith("Part: "):
            parts.append([])
        elif re.match("[a-z]", line):
            text = ROOT / f"book/{line.split()[0]}.md"
            parts[-1] += [text.read_text()] if text.exists() else []
    return [part for part in parts if part]


def pictures(text):
    """The figures and films of a chapter, and what is in them in words."""
    return re.findall(r"^```\{(?:figure-of|film)\} (\S+)\n(?::(?!alt).*\n)*"
                      r":alt: (.*)$", text, re.M)


def faults_of_content(slides, texts):
    """What the chapters have and the deck has not."""
    alts = {slide["id"]: slide["alt"] for slide in slides}
    for text in texts:
        for name, alt in pictures(text):
            if "fig-" + name not in alts:
                yield f"has no slide of {name}"
            elif (alts["fig-" + name] or "").split() != alt.split():
                yield f"has no words for {name}"
    for kind, wanted in (("claim", "^```{theorem}"), ("opener", "^# "),
                         ("question", "^## Open problems"),
                         ("summary", "^```{remember}")):
        least = sum(len(re.findall(wanted, t, re.M)) for t in texts)
        count = sum(kind in slide["kind"].split() for slide in slides)
        if count < least:
            yield f"has {count} slides of the kind {kind}, not {least}"
    if len({slide["id"] for slide in slides}) < len(slides):
        yield "has two slides of one name"


def faults_of_slides(chromium, slides):
    for index, slide in enumerate(slides):
        chromium.execute_script("location.hash = '#' + arguments[0]",
                                slide["id"])
        browse.wait(lambda: shown(chromium) == index)
        for fault in chromium.execute_script(LOOK, SMALLEST):
            yield f"#{slide['id']} {fault}"


def shown(chromium):
    """The number of the slide that is shown."""
    return chromium.execute_script(
        "return [...document.querySelectorAll('.slide')].findIndex("
        "s => s.classList.contains('current') && s.checkVisibility("
        "{visibilityProperty: true}))")


def faults_of_keys(chromium, last):
    body = chromium.find_element(By.TAG_NAME, "body")
    for key, index in ((Keys.HOME, 0), (Keys.ARROW_RIGHT, 1), (Keys.SPACE, 2),
                       (Keys.PAGE_DOWN, 3), (Keys.ARROW_LEFT, 2),
                       (Keys.PAGE_UP, 1), (Keys.END, last),
                       (Keys.ARROW_DOWN, last), (Keys.ARROW_UP, last - 1),
                       ("o", last - 1), (Keys.ESCAPE, last - 1),
                       (Keys.HOME, 0), (Keys.ARROW_LEFT, 0)):
        body.send_keys(key)
        if shown(chromium) != index:
            yield f"shows slide {shown(chromium)} after {key!r}, not {index}"


def faults_of_films(chromium, slides):
    for slide in slides:
        films = chromium.find_elements(
            By.CSS_SELECTOR, f"#{slide['id']} .film input")
        if not films:
            continue
        chromium.execute_script("location.hash = '#' + arguments[0]",
                                slide["id"])
        films[0].parent.switch_to.active_element.send_keys("p")
        if not browse.wait(lambda: chromium.find_elements(
                By.CSS_SELECTOR, f"#{slide['id']} canvas[data-frame]")):
            yield f"#{slide['id']} does not play"
        chromium.switch_to.active_element.send_keys("p")


def faults_of_pdf(pdf, slides):
    """Its pages, as Chromium writes them."""
    data = pdf.read_bytes() if pdf.exists() else b""
    pages = len(re.findall(rb"/Type\s*/Page\b", data))
    if pages != len(slides):
        yield f"has a PDF of {pages} pages for {len(slides)} slides"
    for width, height in set(re.findall(
            rb"/MediaBox\s*\[0 0 ([\d.]+) ([\d.]+)\]", data)):
        if abs(float(width) / float(height) - 16 / 9) > 0.01:
            yield f"has pages of {width.decode()} x {height.decode()}"


def faults_of_deck(chromium, deck, texts):
    for kind in "browser", "performance":
        chromium.get_log(kind)
    chromium.get(deck.as_uri())
    browse.settle(chromium)
    slides = chromium.execute_script(SLIDES)
    yield from faults_of_content(slides, texts)
    yield from faults_of_slides(chromium, slides)
    yield from faults_of_keys(chromium, len(slides) - 1)
    yield from faults_of_films(chromium, slides)
    yield from faults_of_pdf(deck.with_suffix(".pdf"), slides)
    for entry in chromium.get_log("browser"):
        if entry["level"] in ("SEVERE", "WARNING"):
            yield "says on the console: " + entry["message"]
    for address in browse.requests(chromium):
        if urlparse(address).scheme not in ("file", "data"):
            yield "asks for " + address
    print(f"{deck.stem}: {len(slides)} slides")


def main(folder):
    decks, parts = sorted(folder.glob("[1-9]*.html")), chapters()
    found = [] if len(decks) == len(parts) else [
        f"{len(decks)} decks for {len(parts)} parts"]
    chromium = browse.browser()
    try:
        chromium.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": WIDTH, "height": HEIGHT, "deviceScaleFactor": 1,
            "mobile": False})
        chromium.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [
            {"name": "prefers-color-scheme", "value": "dark"}]})
        for deck, texts in zip(decks, parts):
            found += [f"{deck.name} {fault}"
                      for fault in faults_of_deck(chromium, deck, texts)]
    finally:
        chromium.quit()
    for fault in found:
        print(fault, file=sys.stderr)
    print(f"{len(found)} faults")
    return not found


if __name__ == "__main__":
    sys.exit(0 if main(Path(sys.argv[1]).resolve()) else 1)
