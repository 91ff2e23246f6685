"""Mathematics as MathML, made by KaTeX: a page needs no script for it.

MACROS serve both the pages and the print.
"""
import html
import json
import re
import subprocess
import unicodedata
from xml.etree import ElementTree

from docutils import nodes
from sphinx.util import logging
from sphinx.util.math import get_node_equation_number

log = logging.getLogger(__name__)

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

STYLES = {"bold": ["BOLD"], "double-struck": ["DOUBLE-STRUCK"],
          "script": ["SCRIPT"], "bold-italic": ["BOLD ITALIC"],
          "fraktur": ["FRAKTUR", "BLACK-LETTER"],
          "sans-serif": ["SANS-SERIF"], "monospace": ["MONOSPACE"]}

BARS = {"\u2223": "|", "\u2225": "\u2016"}
BREAKING = list("=<>,") + [
    "\u2264", "\u2265", "\u2260", "\u2248", "\u2208", "\u2282", "\u2286",
    "\u2192", "\u21d2", "\u21d4", "\u2261", "\u27fa", "\u27f9"]
SIGNS = ("\u2212", "+", "\u00b1")
LONG = 20       # letters; a shorter formula stays on its line
CLOSING = [")", "]", "}", "|", "\u2016", "\u230b", "\u2309", "\u27e9", "!",
           "\u2032", "%"]


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


def draw_letters(node):
    """Browsers draw letters as they are, whatever their mathvariant."""
    style = node.get("mathvariant")
    if style in STYLES and node.text:
        node.text = "".join(styled(letter, style) for letter in node.text)
        del node.attrib["mathvariant"]


def draw_bars(node):
    """Bars that grow with what they enclose; dots without a gap."""
    if node.tag in ("mo", "mi") and node.text in BARS:
        node.text = BARS[node.text]
    if node.tag == "mo" and node.text == "\u2026":
        node.tag = "mi"
        node.set("mathvariant", "normal")


def draw_signs(node):
    """A sign after an operator or a parenthesis that opens is a prefix."""
    before = None
    for child in node:
        if child.tag == "mspace":
            continue
        if (before is not None and before.tag == "mo"
                and before.text not in CLOSING
                and child.tag == "mo" and child.text in SIGNS):
            child.set("form", "prefix")
        before = child


def draw_names(node):
    """A thin space between the name of a function and its neighbours."""
    children = list(node)
    for before, name, apply, after in zip(
            [None] + children, children, children[1:], children[2:] + [None]):
        if name.tag != "mi" or apply.text != "\u2061":
            continue
        if after is not None and after.tag not in ("mo", "mrow"):
            node.insert(list(node).index(apply) + 1, thin_space())
        if before is not None and (before.tag not in ("mo", "mspace")
                                   or before.text in CLOSING):
            node.insert(list(node).index(name), thin_space())


def thin_space():
    return ElementTree.Element("mspace", width="0.167em")


def draw_primes(node):
    """Primes have their size and height already: they are no superscripts, but
    above a subscript they take the place of one."""
    if node.tag not in ("msup", "msubsup") or not (
            node[-1].tag == "mo" and set(node[-1].text) == {"\u2032"}):
        return
    *base, prime = node
    prime.attrib.update(lspace="0em", rspace="0em")
    if node.tag == "msubsup":
        prime.set("mathsize", "1.4em")
        lowered = ElementTree.Element("mpadded", voffset="-0.5em",
                                      height="0.3em")
        lowered.append(prime)
        node[:] = [*base, lowered]
    else:
        node[:] = [*base, prime]
        node.tag = "mrow"


def draw_end(root):
    """No gap after a relation that ends a formula: a space follows it."""
    row = root[0]
    last = row[-1] if row.tag == "mrow" and len(row) else row
    if last.tag == "mo" and last.text in BREAKING:
        last.set("rspace", "0em")


def pieces(row):
    """The children of a row up to each place where a line may break: after
    a relation or a comma outside of all parentheses."""
    depth, piece = 0, []
    for child in row:
        piece.append(child)
        if child.tag != "mo":
            continue
        depth += (child.text in list("([{")) - (child.text in list(")]}"))
        if depth == 0 and child.text in BREAKING:
            child.set("form", "infix")
            yield piece
            piece = []
    yield piece


def lines(root):
    """A long formula within the text, so that it can fill several lines:
    browsers break none by themselves."""
    row = root[0]
    long = len("".join(root.itertext())) > LONG
    if root.get("display") or row.tag != "mrow" or not long:
        return [root]
    found = []
    for piece in pieces(row):
        found.append(ElementTree.Element("math"))
        ElementTree.SubElement(found[-1], "mrow").extend(piece)
    return found


def legible(math):
    """KaTeX's MathML as browsers draw it best."""
    tree = ElementTree.fromstring(
        math.replace(' xmlns="http://www.w3.org/1998/Math/MathML"', ""))
    root = ElementTree.Element("math", tree.find("math").attrib)
    root.append(tree.find(".//semantics")[0])
    for node in list(root.iter()):
        for draw in draw_letters, draw_bars, draw_signs, draw_names, \
                draw_primes:
            draw(node)
    draw_end(root)
    return "<wbr>".join(ElementTree.tostring(line, encoding="unicode")
                        for line in lines(root))


RAISED = str.maketrans("0123456789+\u2212ni", "\u2070\u00b9\u00b2\u00b3\u2074"
                       "\u2075\u2076\u2077\u2078\u2079\u207a\u207b\u207f\u2071")
LOWERED = str.maketrans("0123456789+\u2212ijkn", "\u2080\u2081\u2082\u2083"
                        "\u2084\u2085\u2086\u2087\u2088\u2089\u208a\u208b\u1d62"
                        "\u2c7c\u2096\u2099")
SPACED = set(BREAKING) - {","} | {"+", "\u2212", "\u22c5", "\u00d7"}


def shifted(text, letters, mark):
    """Text as superscript or subscript, if there are letters for it."""
    text = text.replace(" ", "")
    if set(text) <= {"\u2032"}:
        return text
    if all(ord(letter) in letters for letter in text):
        return text.translate(letters)
    return mark + (text if len(text) == 1 else f"({text})")


def plain(node):
    """A formula in plain letters, for where no formula can be."""
    parts = [plain(child) for child in node]
    if node.tag in ("mi", "mn", "mtext"):
        return node.text or ""
    if node.tag == "mo":
        text = BARS.get(node.text, node.text or "").strip("\u2061")
        text = {"\u22ef": "\u2026"}.get(text, text)
        return f" {text} " if text in SPACED else (
            ", " if text == "," else text)
    if node.tag in ("msup", "mover"):
        return parts[0] + shifted(parts[1].strip(), RAISED, "^")
    if node.tag in ("msub", "munder"):
        return parts[0] + shifted(parts[1].strip(), LOWERED, "_")
    if node.tag in ("msubsup", "munderover"):
        return (parts[0] + shifted(parts[1].strip(), LOWERED, "_")
                + shifted(parts[2].strip(), RAISED, "^"))
    if node.tag == "mfrac":
        return "/".join(part if part.isalnum() else f"({part})"
                        for part in map(str.strip, parts))
    if node.tag == "msqrt":
        return f"\u221a({''.join(parts)})"
    if node.tag == "mtable":
        return "\u2026"
    return "".join(parts)


def plain_text(math):
    """KaTeX's MathML in plain letters."""
    text = " ".join(plain(formula(math)).split())
    for wide, narrow in (("( \u2212 ", "(\u2212"), ("(\u2212 ", "(\u2212"),
                         (" )", ")")):
        text = text.replace(wide, narrow)
    return re.sub("^\u2212 |(?<=[=<>\u2264\u2265,] )\u2212 ", "\u2212", text)


def formula(math):
    """The formula in KaTeX's MathML."""
    tree = ElementTree.fromstring(
        math.replace(' xmlns="http://www.w3.org/1998/Math/MathML"', ""))
    return tree.find(".//semantics")[0]


class Katex:
    """A KaTeX that answers a line with a line."""

    def __init__(self):
        self.process = None

    def answer(self, tex, display):
        if self.process is None:
            self.process = subprocess.Popen(
                ["node", "-e", SERVER], text=True, bufsize=1,
                stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        print(json.dumps([tex, display, MACROS]), file=self.process.stdin)
        answer = json.loads(self.process.stdout.readline())
        if "error" in answer:
            raise ValueError(f"{answer['error']}: {tex}")
        return answer["math"]

    def render(self, tex, display):
        return legible(self.answer(tex, display))

    def plain(self, tex):
        return plain_text(self.answer(tex, False))

    def close(self):
        if self.process is not None:
            self.process.communicate()


GLUED = re.compile(
    r"([(\[\u201c]?)(<math>(?:(?!</?math).)*</math>)([^\s<]*)", re.S)


def glued(body):
    """The page, no line of which ends between a formula within the text and
    a comma, a parenthesis or an ending that touches it."""
    return GLUED.sub(lambda found: f'<span class="glued">{found[0]}</span>'
                     if found[1] or found[3] else found[0], body)


def glue(app, page, template, context, doctree):
    if "body" in context:
        context["body"] = glued(context["body"])


def aligned(tex):
    if r"\begin" in tex or not ("&" in tex or r"\\" in tex):
        return tex
    return r"\begin{aligned}" + tex + r"\end{aligned}"


def setup(app):
    katex = Katex()

    def rendered(node, tex, display):
        """A formula that KaTeX cannot read stands there as it was written."""
        try:
            return katex.render(tex, display)
        except ValueError as error:
            log.warning("%s", error, location=node)
            return html.escape(tex)

    def visit_math(translator, node):
        translator.body.append(rendered(node, node.astext(), False))
        raise nodes.SkipNode

    def visit_math_block(translator, node):
        translator.body.append(translator.starttag(node, "div", CLASS="math"))
        translator.body.append('<div class="equation">')
        translator.body.append(rendered(node, aligned(node.astext()), True))
        translator.body.append("</div>")
        if node["number"]:
            number = get_node_equation_number(translator, node)
            translator.body.append(f'<span class="eqno">({number})</span>')
        translator.body.append("</div>\n")
        raise nodes.SkipNode

    app.add_html_math_renderer("mathml", (visit_math, None),
                               (visit_math_block, None))
    app.config.html_math_renderer = "mathml"
    app.connect("html-page-context", glue)
    app.connect("build-finished", lambda app, error: katex.close())
    return {"version": "1", "parallel_read_safe": True}
