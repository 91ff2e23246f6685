"""Numbers of figures/measured, and claims about them that the build checks; those
of library.csv go by their names, those of methods.csv are named "methods ...",
and so on.

    {measured}`exact near edge-edge:.0f`
    {measured}`expansion / accumulator:.1f`     a number made of rows
    {measured}`machine`                         a line of the file's head
    {claim}`the superaccumulator is faster | accumulator < expansion`

A claim is the words before the bar; what is behind it is not shown, and must be
true of the numbers.  It is made of the names of rows, + - * / and brackets, and
< > <= >= between, and may join comparisons by "and"; a line must not begin with >,
which is Markdown's quotation.
"""
import re

from docutils import nodes
from sphinx.util.docutils import SphinxRole

import drawings


def read(lines, prefix=""):
    """The values of the rows, and the lines of the head, by name."""
    head = dict(re.findall(r"^# (\w+): (.*)$", "\n".join(lines), re.M))
    rows = dict(line.split(",")[:2] for line in lines if line[:1] != "#")
    del rows["name"]    # the line that names the columns
    return ({prefix + name: float(value) for name, value in rows.items()},
            {prefix + name: value for name, value in head.items()})


def numbers(text, rows):
    """A text of names, numbers and signs with a number for each name."""
    names = "|".join(map(re.escape, sorted(rows, key=len, reverse=True)))
    text = re.sub(rf"(?<![\w-])(?:{names})(?![\w-])",
                  lambda found: repr(rows[found[0]]), text)
    number = r"\d+(?:\.\d+)?(?:e[-+]\d+)?"
    if not re.fullmatch(rf"(?:{number}|[-+*/()]|[<>]=?|and|\s)+", text):
        raise ValueError(f"there is no such row in '{text}'")
    return text


def value(text, rows):
    return eval(numbers(text, rows), {"__builtins__": {}})


class MeasuredRole(SphinxRole):
    def run(self):
        for path in self.env.app.measured:
            self.env.note_dependency(str(path))
        try:
            return [self.node()], []
        except (KeyError, ValueError, SyntaxError, TypeError) as error:
            return [], [self.inliner.reporter.error(
                f"figures/measured: '{self.text}': {error}",
                line=self.lineno)]

    def node(self):
        rows, head = self.env.app.measurements
        if self.text in head:
            return nodes.inline("", head[self.text])
        text, _, form = self.text.partition(":")
        tex = drawings.written(float(value(text, rows)), form)
        return nodes.math(tex, tex)


class ClaimRole(MeasuredRole):
    def node(self):
        words, bar, claim = self.text.partition(" | ")
        rows, _ = self.env.app.measurements
        true = value(claim, rows)
        if not isinstance(true, bool):
            raise ValueError("this is no claim 'words | comparison'")
        if not true:
            raise ValueError(f"not true: {numbers(claim, rows)}")
        return nodes.inline("", words)


def begin(app):
    app.measured = sorted((app.root / "figures/measured").glob("*.csv"))
    app.measurements = {}, {}
    for path in app.measured:
        prefix = "" if path.stem == "library" else path.stem + " "
        found = read(path.read_text().splitlines(), prefix)
        for all_of_kind, new in zip(app.measurements, found):
            all_of_kind.update(new)


def setup(app):
    app.add_role("measured", MeasuredRole())
    app.add_role("claim", ClaimRole())
    app.connect("builder-inited", begin)
    return {"version": "1", "parallel_read_safe": False}
