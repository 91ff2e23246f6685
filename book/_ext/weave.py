"""Code in the text.

    ```{fragment} Check the coordinates
    ```
shows a fragment of src/ (book/fragments.py tells what that is); the fragments
within it are links.  Every fragment of a chapter's modules is shown in that
chapter, once.

    ```{sample} Check the coordinates
    ```
shows it a second time, elsewhere, just as its chapter does.

    ```{quote-code} tests/query/point_edge.c: touches_at_the_end
    ```
quotes a function, a test, a fragment or lines (`: 10-20`) of any file.
"""
import functools
import re
import sys
from pathlib import Path

from docutils import nodes
from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.formatters.html import escape_html
from pygments.lexers import TextLexer, get_lexer_for_filename
from pygments.util import ClassNotFound
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective
from sphinx.util.texescape import escape

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).parents[1]))
import fragments
import places

log = logging.getLogger(__name__)


class code_box(nodes.General, nodes.Element):
    """Code with a head: `title`, `number`, `path`, `first`, `last`, `code`.
    In the code, `uses` are the titles of nested fragments; `used_in` is the
    title of the fragment that this one is nested in.  A `sample` has the number
    that its fragment has elsewhere."""


def dedent(line, indent):
    """Preprocessor lines have no indentation to lose."""
    return line if line.startswith("#") else line[indent:]


def shown_lines(fragment):
    """The lines of a fragment as shown, heads standing for its children."""
    for part in fragment.parts:
        if isinstance(part, fragments.Fragment):
            yield " " * (part.indent - fragment.indent) + "//: " + part.title
        else:
            yield dedent(part, fragment.indent)


def children(fragment):
    return [p for p in fragment.parts if isinstance(p, fragments.Fragment)]


def parents(table):
    """The title of the fragment around each nested one."""
    return {child.title: fragment.title for fragment in table.values()
            for child in children(fragment)}


def anchor(title):
    return "fragment-" + nodes.make_id(title)


# The fragments ----------------------------------------------------------------

class FragmentDirective(SphinxDirective):
    required_arguments, final_argument_whitespace = 1, True

    def run(self):
        title = " ".join(self.arguments[0].split())
        fragment = self.env.app.fragments.get(title)
        if fragment is None:
            raise self.error(f"src/ has no fragment '{title}'")
        self.env.note_dependency(str(Path(fragment.path).resolve()))
        return [self.box(fragment)]

    def box(self, fragment):
        title = fragment.title
        box = self.frame(fragment, ids=[anchor(title)], number=self.number())
        box += nodes.Text(title)
        places.of(self.env).note(
            "frag", title, anchor(title),
            f"\u27e8{title}\u202f{box['number']}\u27e9")
        return box

    def frame(self, fragment, **more):
        title = fragment.title
        return code_box(
            title=title,
            path="/".join(Path(fragment.path).parts[1:]),
            first=fragment.first, last=fragment.last,
            code="\n".join(shown_lines(fragment)).rstrip("\n"),
            uses=[child.title for child in children(fragment)],
            used_in=self.env.app.parents.get(title, ""), **more)

    def number(self):
        chapter = self.env.app.chapters.get(self.env.docname)
        if chapter is None:
            raise self.error("only a chapter shows fragments")
        serial = self.env.new_serialno("fragment") + 1
        return f"{chapter.number}.{serial}"


class SampleDirective(FragmentDirective):
    def box(self, fragment):
        return self.frame(fragment, number="", sample=True)


def module(fragment):
    """The module that a fragment is in, as book/chapters names it."""
    return "/".join(Path(fragment.path).with_suffix("").parts[1:])


def check(app, env):
    """Complain of each fragment that is not shown where it should be."""
    home = {m: c.slug for c in app.chapters.values() for m in c.modules}
    for title, fragment in app.fragments.items():
        slug = home.get(module(fragment))
        shown = [p[0] for p in places.of(env).places("frag", title)]
        expected = [slug] if slug in env.found_docs else []
        if shown != expected:
            log.warning("%s:%d: fragment '%s' is shown in %s, should be in %s",
                        fragment.path, fragment.first, title, shown, expected)


# Quotations -------------------------------------------------------------------

def end_of_definition(lines, first):
    """The closing line of what begins here; None: a mere declaration."""
    for body in range(first, len(lines)):
        if lines[body].endswith(";"):
            return None
        if lines[body].endswith("{"):
            return next((end for end in range(body, len(lines))
                         if lines[end].startswith("}")), None)
    return None


def span_of_name(lines, name):
    """A function, test or table, with the comment before it."""
    opening = re.compile(rf"(?!\s|//|#)[^;]*\b{re.escape(name)}\b[^;]*$")
    for first, line in enumerate(lines):
        last = end_of_definition(lines, first) if opening.match(line) else None
        if last is None:
            continue
        while first > 0 and lines[first - 1].startswith("//"):
            first -= 1
        if lines[last + 1:last + 2] == ["END_TEST"]:
            last += 1
        return first + 1, last + 1
    return None


def span_of_prototype(lines, name):
    """The declaration of a function, without the comment before it."""
    opening = re.compile(rf"(?!\s|//|#).*\b{re.escape(name)}\(")
    for first, line in enumerate(lines):
        if opening.match(line):
            return next(((first + 1, last + 1)
                         for last in range(first, len(lines))
                         if lines[last].endswith(";")), None)
    return None


def span_of_fragment(path, text, title):
    for fragment in fragments.walk(fragments.parse(path, text)):
        if fragment.title == title:
            return fragment.first, fragment.last
    return None


def span(path, text, words):
    """The first and the last line of what is quoted; None: not there."""
    lines = text.splitlines()
    if not words:
        return 1, len(lines)
    if re.fullmatch(r"\d+-\d+", words):
        return tuple(map(int, words.split("-")))
    if re.fullmatch(r"\w+", words) and span_of_name(lines, words):
        return span_of_name(lines, words)
    if path.endswith(".h") and span_of_prototype(lines, words):
        return span_of_prototype(lines, words)
    if path.startswith("src/"):
        return span_of_fragment(path, text, words)
    return None


class QuoteDirective(SphinxDirective):
    required_arguments, final_argument_whitespace = 1, True

    def run(self):
        path, _, words = self.arguments[0].partition(":")
        words = " ".join(words.split())
        file = Path(self.env.app.root) / path
        if not file.is_file():
            raise self.error(f"there is no {path}")
        self.env.note_dependency(str(file))
        found = span(path, file.read_text(), words)
        if found is None:
            raise self.error(f"{path} has no '{words}'")
        return [self.box(path, file.read_text().splitlines(), found)]

    def box(self, path, lines, found):
        first, last = found
        lines = [line for line in lines[first - 1:last]]
        indent = min((len(line) - len(line.lstrip()) for line in lines
                      if line.strip() and not line.startswith("#")), default=0)
        code = "\n".join(dedent(line, indent) for line in lines).rstrip()
        return code_box(title="", number="", path=path, first=first, last=last,
                        code=code, uses=[], used_in="")


# The pages --------------------------------------------------------------------

def link(translator, title):
    """A link to a fragment as HTML; plain words where it is not shown."""
    env, here = translator.builder.env, translator.builder.current_docname
    words = f'\u27e8{translator.encode(title)}\u27e9'
    for page, at, _ in places.of(env).places("frag", title):
        uri = translator.builder.get_relative_uri(here, page) + "#" + at
        number = number_of(env, title)
        return (f'<a class="use" href="{uri}">{words}'
                f'<span class="number">{number}</span></a>')
    return words


def number_of(env, title):
    for _, _, name in places.of(env).places("frag", title):
        return name.rsplit("\u202f", 1)[1].rstrip("\u27e9")
    return ""


def head_number(env, node):
    """The number to show in the head of a box; "" for a quotation."""
    sample = node.get("sample")
    return number_of(env, node["title"]) if sample else node["number"]


@functools.lru_cache(maxsize=None)
def lexer(path):
    try:
        return get_lexer_for_filename(path, stripnl=False)
    except ClassNotFound:
        return TextLexer(stripnl=False)


def html_code(translator, node):
    code = highlight(node["code"], lexer(node["path"]),
                     HtmlFormatter(nowrap=True))
    for title in node["uses"]:
        head = f'<span class="c1">//: {escape_html(title)}</span>'
        assert head in code, title
        code = code.replace(head, link(translator, title), 1)
    return code


def visit_html(translator, node):
    lines = f'{node["first"]}\u2013{node["last"]}'
    data = "".join(f' data-{key}="{node[key]}"'
                   for key in ("path", "first", "last") if node["number"])
    add = translator.body.append
    add(translator.starttag(node, "div", CLASS="code-box")[:-2] + data + ">")
    add('<div class="code-head">')
    number = head_number(translator.builder.env, node)
    if number:
        add(f'<p class="code-title">\u27e8{translator.encode(node["title"])}'
            f'<span class="number">{number}</span>\u27e9\u00a0\u2261</p>')
    add(f'<p class="code-where">{node["path"]} <span class="lines">{lines}'
        '</span></p></div>')
    add(f"<pre><code>{html_code(translator, node)}</code></pre>")
    if node["used_in"]:
        add(f'<p class="code-used">in {link(translator, node["used_in"])}</p>')
    add("</div>\n")
    raise nodes.SkipNode


def latex_link(translator, title):
    env = translator.builder.env
    words = r"\tfuse{%s}{%s}" % (escape(title, "xelatex"),
                                 number_of(env, title))
    for page, at, _ in places.of(env).places("frag", title):
        label = translator.idescape(f"{page}:{at}")
        return r"\hyperref[%s]{%s}" % (label, words)
    return words


VERBATIM = r"\begin{Verbatim}[commandchars=\\\{\}]"
BLANK = "\\end{Verbatim}\n\\tfblank\n" + VERBATIM
SHORT = 10      # lines; as many stay on one page
LEAST = 3       # lines before and after the end of a page


def latex_code(translator, node):
    """The lines, highlighted, without the Verbatim around them."""
    lines = translator.highlighter.highlight_block(
        node["code"], lexer(node["path"]).aliases[0]).rstrip().split("\n")[1:-1]
    uses = list(node["uses"])   # none in a quotation, whose heads stay
    return "\n".join(
        BLANK if not line and LEAST <= i < len(lines) - LEAST else
        re.sub(r"\\PYG\{c\+c1\}\{//: .*\}$",
               lambda head: latex_link(translator, uses.pop(0)) if uses
               else head[0], line)
        for i, line in enumerate(lines))


def visit_latex(translator, node):
    where = r"%s\enspace %d--%d" % (escape(node["path"], "xelatex"),
                                    node["first"], node["last"])
    used = node["used_in"] and latex_link(translator, node["used_in"])
    whole = "[unbreakable]" if node["code"].count("\n") < SHORT else ""
    translator.body.append(
        "\n" r"\begin{codebox}%s{%s}{%s}{%s}{%s}{%s}" "\n%s\n%s\n"
        r"\end{Verbatim}" "\n" r"\end{codebox}" "\n" % (
            whole, translator.hypertarget_to(node),
            escape(node["title"], "xelatex"),
            head_number(translator.builder.env, node), where, used,
            VERBATIM, latex_code(translator, node)))
    raise nodes.SkipNode


def begin(app):
    app.root = Path(app.srcdir).parent
    source = app.root / "src"
    app.fragments = {}
    for path in fragments.sources(source):
        name = str(path.relative_to(app.root))
        for fragment in fragments.walk(
                fragments.parse(name, fragments.read(path))):
            app.fragments[fragment.title] = fragment
    app.parents = parents(app.fragments)


def setup(app):
    app.add_node(code_box, html=(visit_html, None), latex=(visit_latex, None))
    app.add_directive("fragment", FragmentDirective)
    app.add_directive("sample", SampleDirective)
    app.add_directive("quote-code", QuoteDirective)
    app.connect("builder-inited", begin)
    app.connect("env-check-consistency", check)
    return {"version": "1", "parallel_read_safe": False}
