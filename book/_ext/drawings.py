"""Figures that build/tanglefree-draw draws, and the numbers that they print.

    ```{figure-of} edge-sweep
    :alt: What the picture shows.
    :wide:
    The caption; {num}`edge-sweep:t:.3f` is the number `t` of the figure.
    ```
{numref}`fig-edge-sweep` refers to it; `:wide:` lets it use the margin.
"""
import functools
import os
import re
import subprocess
import tempfile

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx import addnodes
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective, SphinxRole

log = logging.getLogger(__name__)


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
                   "wide": directives.flag}

    def run(self):
        name = self.arguments[0]
        if name not in listed(self.env.app.drawing):
            raise self.error(f"tanglefree-draw has no figure '{name}'")
        if not self.options.get("alt"):
            raise self.error(f"figure '{name}' needs :alt:, what it shows")
        if not self.content:
            raise self.error(f"figure '{name}' needs a caption")
        self.env.note_dependency(self.env.app.drawing)
        self.env.get_domain("book").note("figure", name, "fig-" + name, name)
        figure = nodes.figure("", classes=["drawing"], align="default")
        if "wide" in self.options:
            figure["classes"].append("wide")
        figure += [self.image("light"), self.dark_image(), self.caption()]
        figure["names"] = ["fig-" + name]
        self.state.document.note_explicit_target(figure)
        widen = r"\tfwidetrue" if "wide" in self.options else ""
        return [nodes.raw("", widen, format="latex"), figure]

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


def written(value, form):
    """A number as LaTeX, whole ones without exponent."""
    if not form and value.is_integer() and abs(value) < 1e15:
        form = ".0f"
    return re.sub(r"e([+-])0*(\d+)",
                  lambda e: r"\times 10^{%s%s}" % (e[1].strip("+"), e[2]),
                  format(value, form))


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
        shown = env.get_domain("book").keys("figure")
        for name in listed(app.drawing):
            if name not in shown:
                log.warning("figure '%s' is not in the book", name)


def begin(app):
    app.drawing = str(app.built / "tanglefree-draw")


def setup(app):
    app.add_directive("figure-of", FigureDirective)
    app.add_role("num", NumberRole())
    app.connect("builder-inited", begin)
    app.connect("env-check-consistency", check)
    return {"version": "1", "parallel_read_safe": False}
