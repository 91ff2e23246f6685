"""Slides for lectures: sphinx-build -b slides makes a deck for each part of the
book, build/slides/1-the-plane.html for instance.

All that is on them is in the chapters.  A chapter's slides are, in this order:

    its title and the beginning of its {opening}
    its figures and films, each with what fits of its caption, and its theorems,
    and those other statements that are marked:
        ```{proposition} Title
        :slide:
    what to {remember}
    a question: the first open problem, or those that are marked
        ```{problem} Title
        :slide:

{figure-of} and {film} take `:slide: 2`, too: the slide has the first two
sentences of the caption, whatever fits.  Links become words, and notes at the
side are left out.
"""
import re
import shutil
import struct
from dataclasses import dataclass
from pathlib import Path

from docutils import nodes
from sphinx import addnodes
from sphinx.builders.html import StandaloneHTMLBuilder

import blocks
import drawings
import manifest
import mathml

OPENING = 420       # letters that fit on the first slide of a chapter
CAPTION = 330       # below a picture, in three lines
BESIDE = 560        # beside a picture
TALL = 1.6          # heights; a picture less wide has its caption beside it
# How many letters fit on a slide by their size, and what else takes room.
SIZES = {"large": 300, "medium": 560, "small": 1000, "smallest": 2000}
BREAKS = {nodes.math_block: 250, nodes.list_item: 10,
          nodes.paragraph: 25}
FORMULA = 0.45      # of the letters of TeX are seen


@dataclass
class Slide:
    kind: str       # opener, picture, claim, summary or question
    anchor: str
    title: str      # HTML, like the next two
    body: str
    label: str = ""
    size: str = ""


# Words ------------------------------------------------------------------------

LEFT_OUT = (nodes.target, addnodes.index, blocks.sidenote)
END = re.compile(r"[.?!][\u201d\u2019)]*(?=\s+(?:[A-Z\u201c(]|$))\s+")


def unlinked(node):
    """A copy as it can stand alone: links are words."""
    copy = node.deepcopy()
    for kind in LEFT_OUT:
        for found in list(copy.findall(kind)):
            found.parent.remove(found)
    for link in list(copy.findall(nodes.reference)):
        link.replace_self(nodes.inline("", "", *link.children))
    return copy


def sentences(words):
    """The children of a node, those of each sentence in a list."""
    found = [[]]
    for child in words:
        if not isinstance(child, nodes.Text):
            found[-1].append(child)
            continue
        text, begin = str(child), 0
        for end in END.finditer(text):
            found[-1].append(nodes.Text(text[begin:end.end()]))
            found.append([])
            begin = end.end()
        if text[begin:]:
            found[-1].append(nodes.Text(text[begin:]))
    return [sentence for sentence in found if sentence]


def letters(node):
    """About how many are seen."""
    if isinstance(node, (nodes.math, nodes.math_block)):
        return FORMULA * len(node.astext())
    if isinstance(node, nodes.Text):
        return len(node.astext())
    return sum(map(letters, node.children))


def leading(words, room, count=None):
    """The first sentences: `count` of them, or those for which there is room,
    and one at least."""
    kept, used = [], 0
    for number, sentence in enumerate(sentences(words)):
        used += sum(map(letters, sentence))
        if number and (number >= count if count else used > room):
            break
        kept += sentence
    return kept


def puzzle(opening):
    """What an opening asks, without what one will be able to do."""
    words = blocks.plain_words(opening)
    kept = nodes.inline()
    for sentence in sentences(leading(words, OPENING)):
        if re.match(r"By\s+the\s+end", sentence[0].astext()):
            break
        kept += sentence
    return kept


def size(text):
    """The class of the largest letters in which it fits."""
    used = letters(text) + sum(
        BREAKS[kind] for kind in BREAKS for _ in text.findall(kind))
    return next(name for name, room in SIZES.items() if used <= room)


# What a chapter has -----------------------------------------------------------

def section_of(node):
    while not isinstance(node, nodes.section):
        node = node.parent
    return node.next_node(nodes.title)


def is_box(node, kind):
    return isinstance(node, nodes.container) and kind in node["classes"]


def shape(png):
    """The width of a picture in heights."""
    with open(png, "rb") as file:
        width, height = struct.unpack(">16x2I", file.read(24))
    return width / height


def only_light(figure):
    """A film knows but one sheet, and no picture is wide."""
    for raw in figure.findall(nodes.raw):
        sheets = {"light": raw["sheets"]["light"]}
        raw[:] = [nodes.Text(drawings.controls(sheets, raw["still"]))]
    figure["classes"] = [c for c in figure["classes"] if c != "wide"]


class Chapter:
    """The slides of a chapter, from its document."""

    def __init__(self, builder, chapter):
        self.builder, self.chapter = builder, chapter
        self.document = builder.env.get_and_resolve_doctree(
            chapter.slug, builder)

    def html(self, node):
        text = self.builder.render_partial(node)["fragment"]
        return re.sub(r' id="[^"]*"', "", mathml.glued(text))

    def words(self, node):
        """The words of a paragraph or a title."""
        return self.html(nodes.inline("", "", *unlinked(node).children))

    def slides(self):
        self.builder.become(self.chapter.slug)
        yield self.first()
        for node in self.document.findall(nodes.Element):
            if isinstance(node, nodes.figure) and "drawing" in node["classes"]:
                yield self.picture(node)
            elif self.is_shown(node):
                yield self.statement(node)
        for node in self.document.findall(nodes.container):
            if is_box(node, "remember"):
                yield self.remember(node)
        yield from map(self.question, self.questions())

    def first(self):
        opening = next(node for node in self.document.findall(nodes.container)
                       if is_box(node, "opening"))
        title = self.words(self.document.next_node(nodes.title))
        asked = puzzle(unlinked(opening))
        return Slide("opener", self.chapter.slug, title,
                     f"<p>{self.html(asked)}</p>",
                     f"Chapter {self.chapter.number}")

    def picture(self, node):
        figure = unlinked(node)
        only_light(figure)
        image, caption = (figure.next_node(kind)
                          for kind in (nodes.image, nodes.caption))
        wide = shape(Path(self.builder.srcdir) / image["uri"]) >= TALL
        caption[:] = leading(caption, CAPTION if wide else BESIDE,
                             figure.get("slide"))
        return Slide("picture " + ("below" if wide else "beside"),
                     node["names"][0], self.words(section_of(node)),
                     self.html(figure))

    def is_shown(self, node):
        return isinstance(node, blocks.theorem) or (
            isinstance(node, blocks.statement) and node["slide"]
            and not isinstance(node, blocks.problem))

    def label(self, node):
        kind = blocks.kind_of(node)
        number = self.builder.fignumbers[kind][node["ids"][0]]
        return f"{kind.capitalize()}\u00a0{'.'.join(map(str, number))}"

    def text_slide(self, kind, node, title, label, found):
        anchor = f"{self.chapter.slug}-{node['ids'][0]}" if node["ids"] else \
            f"{self.chapter.slug}-{kind}"
        text = nodes.container("", *found)
        return Slide(kind, anchor, title, self.html(text), label, size(text))

    def statement(self, node):
        return self.text_slide("claim", node, node["title"],
                               self.label(node), unlinked(node).children)

    def questions(self):
        problems = list(self.document.findall(blocks.problem))
        return [p for p in problems if p["slide"]] or problems[:1]

    def question(self, node):
        return self.text_slide("question", node, node["title"], "A question",
                               unlinked(node).children)

    def remember(self, node):
        title, *found = unlinked(node).children
        return self.text_slide("summary", node, self.words(title), "", found)


# The decks --------------------------------------------------------------------

@dataclass
class Deck:
    name: str
    title: str
    number: str     # Roman
    chapters: list  # of pairs: a Chapter and its slides

    @property
    def count(self):
        return 1 + sum(len(slides) for _, slides in self.chapters)


def deck_name(number, title):
    return f"{number}-{nodes.make_id(title)}"


class SlidesBuilder(StandaloneHTMLBuilder):
    name = "slides"

    def get_outdated_docs(self):
        return "all decks"

    def become(self, docname):
        """Number what is rendered as on that page."""
        self.current_docname = docname
        self.secnumbers = self.env.toc_secnumbers.get(docname, {})
        self.fignumbers = self.env.toc_fignumbers.get(docname, {})
        self.imgpath = "_images"

    def write(self, *_):
        self.prepare_writing({self.config.root_doc})
        decks = list(self.decks())
        for deck in decks:
            self.write_page(deck.name, "slides.html", deck=deck,
                            cover=self.cover())
        self.write_page("index", "decks.html", decks=decks)

    def decks(self):
        here = manifest.written(self.env)
        for number, part in enumerate(dict.fromkeys(c.part for c in here), 1):
            chapters = [Chapter(self, c) for c in here if c.part == part]
            for chapter in chapters:
                self.take_pictures(chapter.document)
            yield Deck(deck_name(number, part), part,
                       chapters[0].chapter.part_number,
                       [(c.chapter, list(c.slides())) for c in chapters])

    def take_pictures(self, document):
        """Those of the dark stay where they are."""
        for image in list(document.findall(nodes.image)):
            if "on-dark" in image["classes"]:
                image.parent.remove(image)
        self.post_process_images(document)

    def cover(self):
        document = self.env.get_and_resolve_doctree(self.config.root_doc, self)
        self.take_pictures(document)
        self.become(self.config.root_doc)
        return self.render_partial(
            document.next_node(nodes.image).deepcopy())["fragment"]

    def write_page(self, name, template, **context):
        (Path(self.outdir) / f"{name}.html").write_text(
            self.templates.render(template, context))

    def finish(self):
        self.copy_image_files()
        self.copy_static_files()
        folder = Path(self.outdir) / "_images/films"
        folder.mkdir(parents=True, exist_ok=True)
        for name in self.env.get_domain("book").keys("film"):
            shutil.copy2(self.app.built / "films" / f"{name}-light.png", folder)


def setup(app):
    app.add_builder(SlidesBuilder)
    return {"version": "1", "parallel_read_safe": True}
