"""Figures that build/tanglefree-draw draws, and the numbers that they print.

    ```{figure-of} edge-sweep
    :alt: What the picture shows.
    :wide:
    The caption; {num}`edge-sweep:t:.3f` is the number `t` of the figure.
    ```
{numref}`fig-edge-sweep` refers to it; `:wide:` lets it use the margin.

    ```{film} edge-sweep
    :alt: What the picture shows.
    The caption.
    ```
is the same for a figure that moves.  On paper and without script it is that
picture, the still.  Otherwise a button and a slider below it (film.js) show the
frames that figures/rules.mk draws, at times from 0 to 1; first the slider is at
the time that the figure prints as `film_still`.  With `:frames: winding` they
are the frames of another figure, while the still is a strip of pictures, for
instance.  The frames are on a sheet for each theme, which figures/draw/sheet.h
describes.  A page loads that of its theme when the film comes into sight.

    ```{cover-of} cover
    :alt: What the picture shows.
    ```
is the picture alone; in print it is on the title page (conf.py).
"""
import functools
import json
import os
import re
import shutil
import struct
import subprocess
import tempfile
from pathlib import Path

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx import addnodes
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective, SphinxRole

log = logging.getLogger(__name__)
THEMES = "light", "dark"


@functools.lru_cache(maxsize=None)
def numbers(program, figure):
    """What a figure prints as it is drawn: its numbers by key."""
    with tempfile.TemporaryDirectory() as folder:
        printed = subprocess.run(
            [program, "figure", figure, "--size=40x30", "-o",
             f"{folder}/small.png"],
            text=True, capture_output=True, check=True).stdout
    return dict(line.split(None, 1) for line in printed.splitlines())


@functools.lru_cache(maxsize=None)
def listed(program):
    """The names of all figures."""
    printed = subprocess.run([program, "list"], text=True,
                             capture_output=True, check=True).stdout
    return [line.split()[0] for line in printed.splitlines() if line.strip()]


class FigureDirective(SphinxDirective):
    required_arguments, has_content = 1, True
    option_spec = {"alt": directives.unchanged_required,
                   "wide": directives.flag,
                   "slide": directives.positive_int}
    classes = ["drawing"]

    def run(self):
        name = self.arguments[0]
        if not self.content:
            raise self.error(f"figure '{name}' needs a caption")
        self.note(name)
        figure = nodes.figure("", classes=self.classes, align="default")
        if "wide" in self.options:
            figure["classes"].append("wide")
        figure["slide"] = self.options.get("slide")     # for slides.py
        figure += [self.image("light"), self.dark_image(), *self.controls(),
                   self.caption()]
        figure["names"] = ["fig-" + name]
        self.state.document.note_explicit_target(figure)
        widen = r"\tfwidetrue" if "wide" in self.options else ""
        return [nodes.raw("", widen, format="latex"), figure]

    def note(self, name):
        if name not in listed(self.env.app.drawing):
            raise self.error(f"tanglefree-draw has no figure '{name}'")
        if not self.options.get("alt"):
            raise self.error(f"figure '{name}' needs :alt:, what it shows")
        self.env.note_dependency(self.env.app.drawing)
        self.env.get_domain("book").note("figure", name, "fig-" + name, name)

    def image(self, theme):
        """PNG in a browser, PDF on paper: Sphinx takes the one it likes."""
        folder = os.path.relpath(self.env.app.built / "figures",
                                 self.env.srcdir)
        return nodes.image(uri=f"{folder}/{self.arguments[0]}-{theme}.*",
                           alt=self.options["alt"], classes=["on-" + theme])

    def dark_image(self):
        return addnodes.only("", self.image("dark"), expr="html")

    def caption(self):
        words = nodes.Element()
        self.state.nested_parse(self.content, self.content_offset, words)
        return nodes.caption("", "", *(child for paragraph in words
                                       for child in paragraph.children))

    def controls(self):
        """What is between the picture and the caption."""
        return []


def text_chunks(png):
    """The texts in the bytes of a PNG file, by key."""
    found, at = {}, 8
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        if kind == b"tEXt":
            key, text = png[at + 8:at + 8 + length].split(b"\0", 1)
            found[key.decode()] = text.decode()
        at += length + 12
    return found


def read_film(sheet):
    """What film.js needs to know of a sheet."""
    head, *frames = text_chunks(Path(sheet).read_bytes())["film"].splitlines()
    width, height, tile, columns, count = map(int, head.split())
    if count != len(frames):
        raise ValueError(f"{sheet}: {len(frames)} frames instead of {count}")
    return {"width": width, "height": height, "tile": tile,
            "columns": columns, "frames": frames}


CONTROLS = """\
<div class="film-controls" hidden>
<button type="button" aria-label="Play"></button>
<input type="range" min="0" max="{last}" value="{still}" aria-label="Time">
<script type="application/json">{sheets}</script>
</div>
"""


def controls(sheets, still):
    """The controls of a film: `sheets` has for each theme what its sheet is;
    `still` is a time."""
    last = len(sheets["light"]["frames"]) - 1
    text = json.dumps(sheets, separators=(",", ":")).replace("<", "\\u003c")
    return CONTROLS.format(last=last, still=round(still * last), sheets=text)


class FilmDirective(FigureDirective):
    option_spec = {**FigureDirective.option_spec,
                   "frames": directives.unchanged_required}
    classes = ["drawing", "film"]

    def controls(self):
        name = self.options.get("frames", self.arguments[0])
        program = self.env.app.drawing
        if name not in listed(program):
            raise self.error(f"tanglefree-draw has no figure '{name}'")
        if "film_still" not in numbers(program, name):
            raise self.error(f"figure '{name}' does not move")
        sheets = {}
        for theme in THEMES:
            sheet = self.env.app.built / "films" / f"{name}-{theme}.png"
            self.env.note_dependency(str(sheet))
            sheets[theme] = {"sheet": f"_images/films/{sheet.name}",
                             **read_film(sheet)}
        self.env.get_domain("book").note(
            "film", name, "fig-" + self.arguments[0], name)
        still = float(numbers(program, name)["film_still"])
        return [nodes.raw("", controls(sheets, still), format="html",
                          sheets=sheets, still=still)]


def copy_sheets(app, error):
    """Put the sheets of all films where the pages look for them."""
    if error is None and app.builder.name == "html":
        folder = Path(app.outdir) / "_images" / "films"
        folder.mkdir(parents=True, exist_ok=True)
        for name in app.env.get_domain("book").keys("film"):
            for theme in THEMES:
                shutil.copy2(app.built / "films" / f"{name}-{theme}.png",
                             folder)


class CoverDirective(FigureDirective):
    has_content = False

    def run(self):
        self.note(self.arguments[0])
        pictures = nodes.container("", self.image("light"), self.image("dark"),
                                   classes=["drawing", "cover-picture"])
        return [addnodes.only("", pictures, expr="html")]


def written(value, form):
    """A number as LaTeX, whole ones without exponent, thousands apart."""
    if not form and value.is_integer() and abs(value) < 1e15:
        form = ".0f"
    text = re.sub(r"^-?\d{4,}",
                  lambda whole: f"{int(whole[0]):,}".replace(",", "{,}"),
                  format(value, form))
    return re.sub(r"e([+-])0*(\d+)",
                  lambda e: r"\times 10^{%s%s}" % (e[1].strip("+"), e[2]), text)


class NumberRole(SphinxRole):
    def run(self):
        figure, key, form = (self.text.split(":", 2) + ["", ""])[:3]
        try:
            found = numbers(self.env.app.drawing, figure)
            tex = written(float(found[key]), form)
        except (KeyError, ValueError, subprocess.CalledProcessError):
            return [], [self.inliner.reporter.error(
                f"figure '{figure}' prints no number '{key}', or none that "
                f"is written as '{form}'", line=self.lineno)]
        return [nodes.math(tex, tex)], []


def check(app, env):
    """Once all chapters are written, each figure is in the book."""
    if all(slug in env.found_docs for slug in app.chapters):
        book = env.get_domain("book")
        shown = book.keys("figure") + book.keys("film")
        for name in listed(app.drawing):
            if name not in shown:
                log.warning("figure '%s' is not in the book", name)


def begin(app):
    app.drawing = str(app.built / "tanglefree-draw")


def setup(app):
    app.add_directive("figure-of", FigureDirective)
    app.add_directive("film", FilmDirective)
    app.add_directive("cover-of", CoverDirective)
    app.add_role("num", NumberRole())
    app.connect("builder-inited", begin)
    app.connect("env-check-consistency", check)
    app.connect("build-finished", copy_sheets)
    return {"version": "1", "parallel_read_safe": False}
