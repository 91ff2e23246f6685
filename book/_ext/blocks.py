"""The blocks of a chapter.

    ```{opening}            what the reader will be able to do; comes first
    ```{margin} Title       a note beside the paragraph that follows
    ```{remember}           what to remember; comes at the end
    ```{report}             what the report claims here, and what holds of it
    ```{theorem} Title      lemma, corollary, proposition, definition,
    :name: label            algorithm, example and remark too; {numref}`label`
    ```{proof} of the lemma
    ```{problem} Title      an open problem
    :difficulty: 2          1 to 3
    ```{exercise} 03-1      title and task are in exercises/03-1-*.c
    {def}`worldline`        a term where it is defined: bold, in the index
    {def}`worldlines <worldline>`
"""
import re

from docutils import nodes
from docutils.parsers.rst import directives
from docutils.statemachine import StringList
from sphinx import addnodes
from sphinx.util import logging
from sphinx.util.docutils import ReferenceRole, SphinxDirective
from sphinx.util.texescape import escape

import formulas
import places

log = logging.getLogger(__name__)


def parsed(directive, content=None):
    """The nodes of a directive's content."""
    found = nodes.Element()
    directive.state.nested_parse(
        directive.content if content is None else content,
        directive.content_offset, found)
    return found.children


def block_title(*words):
    return nodes.inline("", "", *words, classes=["block-title"])


class Block(SphinxDirective):
    """A box named as the directive, its optional title as the first line."""
    has_content, optional_arguments = True, 1
    final_argument_whitespace = True

    def run(self):
        self.assert_has_content()
        box = nodes.container("", *parsed(self), classes=[self.name])
        title = self.title()
        if title:
            words, messages = self.state.inline_text(title, self.lineno)
            self.entitle(box, block_title(*words, *messages))
        return [box]

    def title(self):
        return self.arguments[0] if self.arguments else ""

    def entitle(self, box, title):
        box.insert(0, nodes.paragraph("", "", title, classes=["title-line"]))


def plain_words(box):
    """The paragraphs of a box as one, without references."""
    words = nodes.inline()
    for paragraph in box.deepcopy().children:
        words.extend([*paragraph.children, nodes.Text(" ")])
    for reference in list(words.findall(addnodes.pending_xref)):
        reference.replace_self(nodes.Text(reference.astext()))
    return words


class Opening(Block):
    def run(self):
        boxes = super().run()
        self.env.abstracts[self.env.docname] = plain_words(boxes[0])
        return boxes


class Remember(Block):
    def title(self):
        return super().title() or "What to remember"


class Report(Block):
    optional_arguments = 0

    def title(self):
        return "The report, line by line"


class Proof(Block):
    def title(self):
        return " ".join(["Proof", *self.arguments]) + "."

    def entitle(self, box, title):
        """At the head of the first line, and a square at the end."""
        if not isinstance(box[0], nodes.paragraph):
            box.insert(0, nodes.paragraph())
        box[0].insert(0, [title, nodes.Text(" ")])
        if not isinstance(box[-1], nodes.paragraph):
            box.append(nodes.paragraph())
        box[-1].append(nodes.inline("", "\u25a1", classes=["qed"]))


# Numbered statements ----------------------------------------------------------

class statement(nodes.General, nodes.Element):
    """A numbered block; its class is its kind, `title` may be empty."""


class theorem(statement):
    pass


class lemma(statement):
    pass


class corollary(statement):
    pass


class proposition(statement):
    pass


class formal_definition(statement):
    """Docutils has a `definition` of its own."""


class algorithm(statement):
    pass


class example(statement):
    pass


class remark(statement):
    pass


class problem(statement):
    """An open problem; it has a `difficulty` of 1 to 3."""


KINDS = {kind.__name__.replace("formal_", ""): kind for kind in (
    theorem, lemma, corollary, proposition, formal_definition, algorithm,
    example, remark, problem)}


class Statement(SphinxDirective):
    has_content, optional_arguments = True, 1
    final_argument_whitespace = True
    option_spec = {"name": directives.unchanged_required,
                   "slide": directives.flag}

    def run(self):
        self.assert_has_content()
        node = KINDS[self.name]("", *parsed(self), title="", difficulty=0,
                                slide="slide" in self.options)
        if self.arguments:
            node["title"] = self.arguments[0]
        node["ids"] = [f"{self.name}-{self.env.new_serialno(self.name) + 1}"]
        self.add_name(node)
        return [node]


class Problem(Statement):
    option_spec = {**Statement.option_spec, "difficulty": int}

    def run(self):
        difficulty = self.options.get("difficulty", 0)
        if not 1 <= difficulty <= 3:
            raise self.error("an open problem needs :difficulty:, 1 to 3")
        node, = super().run()
        node["difficulty"] = difficulty
        return [node]


def kind_of(node):
    return node.tagname.replace("formal_", "")


def title_of(node):
    return node["title"] or kind_of(node).capitalize()


def visit_statement_html(translator, node):
    kind = kind_of(node)
    translator.body.append(translator.starttag(
        node, "div", CLASS=f"statement {kind}"))
    translator.body.append('<p class="statement-head">')
    translator.add_fignumber(node)
    if node["title"]:
        translator.body.append('<span class="statement-title">'
                               f'{translator.encode(node["title"])}</span> ')
    if node["difficulty"]:
        hard = node["difficulty"]
        translator.body.append(
            f'<span class="difficulty" role="img" aria-label="difficulty '
            f'{hard} of 3">{"★" * hard}{"☆" * (3 - hard)}</span>')
    translator.body.append("</p>\n")


def depart_statement_html(translator, node):
    translator.body.append("</div>\n")


def visit_statement_latex(translator, node):
    hard = node["difficulty"]
    marks = r"\difficulty{%d}" % hard if hard else ""
    title = "[%s]" % escape(node["title"], "xelatex") if node["title"] else ""
    translator.body.append("\n" r"\begin{tf%s}%s%s%s" "\n" % (
        kind_of(node), title, translator.hypertarget_to(node), marks))


def depart_statement_latex(translator, node):
    translator.body.append("\n" r"\end{tf%s}" "\n" % kind_of(node))


# Exercises --------------------------------------------------------------------

COMMENT = re.compile(r"\s*/\*(.*?)\*/|((?:\s*//.*\n)+)", re.S)
HEAD = re.compile(r"Exercise (\d+)\.(\d+)[.:]\s+(.*?)\.?$", re.S)


def opening_comment(text):
    """The paragraphs of the comment that opens a C file."""
    found = COMMENT.match(text)
    lines = (found[1] or found[2] or "").splitlines() if found else []
    lines = [re.sub(r"^\s*(\*|///?)? ?", "", line).rstrip() for line in lines]
    return [p for p in re.split(r"\n\s*\n", "\n".join(lines).strip("\n")) if p]


def task(paragraphs):
    """What comes before the hints and what only a machine reads."""
    for paragraph in paragraphs:
        if re.match(r"Hints?\b|Section\b", paragraph):
            return
        yield paragraph


class Exercise(SphinxDirective):
    required_arguments = 1

    def run(self):
        key = self.arguments[0]
        files = [f for f in (self.env.app.root / "exercises").glob(f"{key}-*.c")
                 if not f.name.endswith(".check.c")]
        if len(files) != 1:
            raise self.error(f"exercises/ has {len(files)} files {key}-*.c")
        self.env.note_dependency(str(files[0]))
        head, *text = opening_comment(files[0].read_text()) or [""]
        title = HEAD.match(head)
        if not title or [int(n) for n in key.split("-")] != [
                int(title[1]), int(title[2])]:
            raise self.error(f"{files[0].name} does not begin 'Exercise N.k.'")
        return self.boxes(key, title, text)

    def boxes(self, key, title, text):
        number = f"Exercise\u00a0{title[1]}.{title[2]}"
        anchor = "exercise-" + key
        places.of(self.env).note("ex", key, anchor, number)
        words = " ".join(title[3].split())
        head = nodes.paragraph("", "", block_title(
            nodes.strong("", number), nodes.Text("\u2002" + words)),
            classes=["title-line"])
        content = StringList("\n\n".join(
            map(formulas.from_ascii, task(text))).splitlines(),
            self.env.docname)
        return [nodes.target("", "", ids=[anchor]),
                nodes.container("", head, *parsed(self, content),
                                classes=["exercise"])]


def check_exercises(app, env):
    """The exercises of a chapter are in it, each once."""
    slugs = {c.number: c.slug for c in app.chapters.values()}
    for file in sorted((app.root / "exercises").glob("[0-9]*-[0-9]*-*.c")):
        number, k = file.name.split("-")[:2]
        home = slugs.get(int(number))
        if home not in env.found_docs or file.name.endswith(".check.c"):
            continue
        shown = [p[0] for p in places.of(env).places("ex", f"{number}-{k}")]
        if shown != [home]:
            log.warning("%s is in %s, should be in ['%s']", file.name, shown,
                        home)


# Terms ------------------------------------------------------------------------

class DefinitionRole(ReferenceRole):
    def run(self):
        anchor = f"def-{nodes.make_id(self.target)}"
        if anchor in self.inliner.document.ids:
            anchor += f"-{self.env.new_serialno('def') + 1}"
        entry = addnodes.index(entries=[
            ("single", self.target, anchor, "main", None)])
        target = nodes.target("", "", ids=[anchor])
        self.inliner.document.note_explicit_target(target)
        term = nodes.strong("", self.title, classes=["def"])
        return [entry, target, term], []


# Notes at the side ------------------------------------------------------------

class sidenote(nodes.Inline, nodes.TextElement):
    """A footnote moved to where it is referred to; has a `number`."""


def move_footnotes(app, doctree):
    """Put each footnote where its reference is."""
    footnotes = {f["ids"][0]: f for f in doctree.findall(nodes.footnote)}
    references = list(doctree.findall(nodes.footnote_reference))
    for number, reference in enumerate(references, 1):
        footnote = footnotes[reference["refid"]]
        words = [child for paragraph in footnote.findall(nodes.paragraph)
                 for child in paragraph.children]
        reference.replace_self(sidenote("", "", *words, number=number))
    for footnote in footnotes.values():
        footnote.parent.remove(footnote)


def loose_notes(text):
    """The footnotes that have either no text or no reference, with lines."""
    places = [(found[1], bool(found[2]), text.count("\n", 0, found.start()) + 1)
              for found in re.finditer(r"\[\^([^\]\s]+)\](:?)", text)]
    texts = {name for name, is_text, _ in places if is_text}
    references = {name for name, is_text, _ in places if not is_text}
    return [(name, is_text, line) for name, is_text, line in places
            if name not in (references if is_text else texts)]


def check_notes(app, docname, source):
    """Markdown says nothing of them."""
    for name, is_text, line in loose_notes(source[0]):
        log.warning("note [^%s] has no %s", name,
                    "reference" if is_text else "text",
                    location=(docname, line))


def visit_sidenote_html(translator, node):
    number = node["number"]
    translator.body.append(
        f'<label class="note-mark" for="note-{number}">{number}</label>'
        f'<input class="note-switch" type="checkbox" id="note-{number}" '
        f'aria-label="Show note {number}">'
        f'<span class="sidenote" role="note"><span class="note-number">'
        f'{number}</span> ')


def depart_sidenote_html(translator, node):
    translator.body.append("</span>")


def visit_sidenote_latex(translator, node):
    translator.body.append(r"\tfnote{")


def depart_sidenote_latex(translator, node):
    translator.body.append("}")


# Paragraphs -------------------------------------------------------------------

def drop_empty(app, doctree):
    """An empty cell of a table is not a cell with an empty paragraph."""
    for paragraph in list(doctree.findall(nodes.paragraph)):
        if not paragraph.children and isinstance(paragraph.parent, nodes.entry):
            paragraph.parent.remove(paragraph)


def goes_on(paragraph):
    """Whether it goes on with the sentence before the code above it."""
    index = paragraph.parent.index(paragraph)
    before = paragraph.parent[index - 1] if index else paragraph
    return (paragraph.astext()[:1].islower()
            and not isinstance(before, (nodes.paragraph, nodes.title)))


def run_on(app, doctree, docname):
    """In print a paragraph is indented, but not what goes on after code."""
    for paragraph in list(doctree.findall(nodes.paragraph)):
        if app.builder.format == "latex" and goes_on(paragraph):
            index = paragraph.parent.index(paragraph)
            paragraph.parent.insert(index, nodes.raw(
                "", r"\tfrunon", format="latex"))


def setup(app):
    for name, block in ("opening", Opening), ("margin", Block), \
            ("remember", Remember), ("report", Report), ("proof", Proof), \
            ("problem", Problem), ("exercise", Exercise):
        app.add_directive(name, block)
    for name, kind in KINDS.items():
        if name != "problem":
            app.add_directive(name, Statement)
        app.add_enumerable_node(
            kind, name, title_of,
            html=(visit_statement_html, depart_statement_html),
            latex=(visit_statement_latex, depart_statement_latex))
    app.add_node(sidenote,
                 html=(visit_sidenote_html, depart_sidenote_html),
                 latex=(visit_sidenote_latex, depart_sidenote_latex))
    app.add_role("def", DefinitionRole())
    app.connect("source-read", check_notes)
    app.connect("doctree-read", move_footnotes)
    app.connect("doctree-read", drop_empty)
    app.connect("doctree-resolved", run_on)
    app.connect("env-check-consistency", check_exercises)
    return {"version": "1", "parallel_read_safe": False}
