"""Mathematics as MathML, made by KaTeX: a page needs no script for it.

MACROS serve both the pages and the print.
"""
import json
import re
import subprocess
import unicodedata

from docutils import nodes
from sphinx.util.math import get_node_equation_number

MACROS = {
    r"\R": r"\mathbb{R}", r"\Z": r"\mathbb{Z}", r"\F": r"\mathbb{F}",
    r"\sign": r"\operatorname{sign}", r"\orient": r"\operatorname{orient}",
    r"\conv": r"\operatorname{conv}", r"\ulp": r"\operatorname{ulp}",
    r"\fl": r"\operatorname{fl}", r"\meet": r"\operatorname{meet}",
    r"\perm": r"\operatorname{perm}",
    r"\abs": r"\left|#1\right|", r"\norm": r"\left\|#1\right\|",
    r"\ceil": r"\left\lceil#1\right\rceil",
    r"\floor": r"\left\lfloor#1\right\rfloor",
    r"\vec": r"\mathbf{#1}", r"\T": r"^{\mathsf{T}}", r"\half": r"\tfrac12",
}

SERVER = r"""
const katex = require('/usr/share/javascript/katex/katex.js');
require('readline').createInterface({input: process.stdin}).on('line', l => {
  const [tex, displayMode, macros] = JSON.parse(l);
  let answer;
  try {
    answer = {math: katex.renderToString(tex, {
      output: 'mathml', displayMode, macros, strict: true})};
  } catch (error) { answer = {error: String(error)}; }
  console.log(JSON.stringify(answer));
});"""

VARIANT = re.compile(r'<(m\w+) mathvariant="([\w-]+)"([^>]*)>([^<]*)</\1>')
STYLES = {"bold": ["BOLD"], "double-struck": ["DOUBLE-STRUCK"],
          "script": ["SCRIPT"], "bold-italic": ["BOLD ITALIC"],
          "fraktur": ["FRAKTUR", "BLACK-LETTER"],
          "sans-serif": ["SANS-SERIF"], "monospace": ["MONOSPACE"]}


def preamble():
    """The macros as LaTeX defines them."""
    return "".join(
        r"\providecommand{%s}{}\renewcommand{%s}%s{%s}" "\n" % (
            name, name, "[1]" if "#1" in body else "", body)
        for name, body in MACROS.items())


def styled(letter, style):
    """A letter in a mathematical alphabet; itself where it has none."""
    name = unicodedata.name(letter, "")
    short = re.sub(r"^(LATIN|GREEK) (CAPITAL|SMALL) LETTER ", r"\2 ", name)
    short = short.replace("LATIN ", "")
    for prefix in STYLES.get(style, []):
        for full in f"MATHEMATICAL {prefix} {short}", f"{prefix} {short}":
            try:
                return unicodedata.lookup(full)
            except KeyError:
                pass
    return letter


def without_variants(math):
    """Browsers draw letters as they are, whatever their mathvariant."""
    def replace(found):
        tag, style, rest, letters = found.groups()
        if style == "normal":
            return found[0]
        letters = "".join(styled(letter, style) for letter in letters)
        return f"<{tag}{rest}>{letters}</{tag}>"
    return VARIANT.sub(replace, math)


def legible(math):
    """Bars that grow with what they enclose, dots without a gap."""
    for bar, fence in ("\u2223", "|"), ("\u2225", "\u2016"):
        math = re.sub(f'(<m[oi][^>]*>){bar}</m', rf"\1{fence}</m", math)
    return math.replace("<mo>\u2026</mo>",
                        '<mi mathvariant="normal">\u2026</mi>')


class Katex:
    """A KaTeX that answers a line with a line."""

    def __init__(self):
        self.process = None

    def render(self, tex, display):
        if self.process is None:
            self.process = subprocess.Popen(
                ["node", "-e", SERVER], text=True, bufsize=1,
                stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        print(json.dumps([tex, display, MACROS]), file=self.process.stdin)
        answer = json.loads(self.process.stdout.readline())
        if "error" in answer:
            raise ValueError(f"{answer['error']}: {tex}")
        return legible(without_variants(answer["math"]))

    def close(self, app, error):
        if self.process is not None:
            self.process.communicate()


def aligned(tex):
    if r"\begin" in tex or not ("&" in tex or r"\\" in tex):
        return tex
    return r"\begin{aligned}" + tex + r"\end{aligned}"


def setup(app):
    katex = Katex()

    def visit_math(translator, node):
        translator.body.append(katex.render(node.astext(), False))
        raise nodes.SkipNode

    def visit_math_block(translator, node):
        translator.body.append(translator.starttag(node, "div", CLASS="math"))
        translator.body.append('<div class="equation">')
        translator.body.append(katex.render(aligned(node.astext()), True))
        translator.body.append("</div>")
        if node["number"]:
            number = get_node_equation_number(translator, node)
            translator.body.append(f'<span class="eqno">({number})</span>')
        translator.body.append("</div>\n")
        raise nodes.SkipNode

    app.add_html_math_renderer("mathml", (visit_math, None),
                               (visit_math_block, None))
    app.config.html_math_renderer = "mathml"
    app.connect("build-finished", katex.close)
    return {"version": "1", "parallel_read_safe": True}
