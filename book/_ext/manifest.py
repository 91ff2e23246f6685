"""The chapters: order, numbers and parts, all from book/chapters.

A chapter without a text file is absent from the book, yet it keeps its number.

    ```{book-contents} preface | epilogue reference formats notation bibliography
    ```
lists the book on its first page: pages before the chapters, then pages after.

    {chapter}`exact`    "Chapter 10", a link once the chapter is written
"""
import functools
from dataclasses import dataclass
from pathlib import Path

from docutils import nodes
from sphinx import addnodes
from sphinx.directives.other import TocTree
from sphinx.util.docutils import SphinxDirective, SphinxRole
from docutils.statemachine import StringList

PART = "Part: "
ROMAN = ["", "I", "II", "III", "IV", "V", "VI", "VII", "VIII", "IX", "X"]


@dataclass(frozen=True)
class Chapter:
    slug: str
    number: int
    part: str           # its title
    part_number: str    # Roman
    modules: tuple


def chapters(path):
    """The chapters of a manifest, by slug, in order."""
    found, parts = {}, [""]
    for line in Path(path).read_text().splitlines():
        if line.startswith(PART):
            parts.append(line[len(PART):])
        elif line.strip() and not line.startswith("#"):
            slug, *modules = line.split()
            found[slug] = Chapter(slug, len(found) + 1, parts[-1],
                                  ROMAN[len(parts) - 1], tuple(modules))
    return found


def opens_part(written, chapter):
    """Whether none of the written chapters before it is in its part."""
    return next(c for c in written if c.part == chapter.part) is chapter


def written(env):
    return [c for c in env.app.chapters.values() if c.slug in env.found_docs]


class ContentsDirective(SphinxDirective):
    required_arguments, final_argument_whitespace = 1, True

    def run(self):
        before, _, after = self.arguments[0].partition("|")
        slugs = [c.slug for c in written(self.env)]
        pages = self.env.app.builder.format == "html"
        index = ["genindex"] if pages else []   # LaTeX adds it by itself
        return [self.part_of_contents(before.split()),
                self.part_of_contents(slugs, numbered=2),
                self.part_of_contents(after.split() + index)]

    def part_of_contents(self, slugs, **options):
        """A hidden toctree: the theme draws the contents."""
        toctree = TocTree(self.name, [], {"hidden": True, **options},
                          StringList(slugs, self.env.docname), self.lineno,
                          self.content_offset, "", self.state,
                          self.state_machine)
        return nodes.container("", *toctree.run())


class ChapterRole(SphinxRole):
    def run(self):
        chapter = self.env.app.chapters.get(self.text)
        if chapter is None:
            message = self.inliner.reporter.error(
                f"book/chapters has no '{self.text}'", line=self.lineno)
            return [], [message]
        words = nodes.inline("", f"Chapter\u00a0{chapter.number}")
        if chapter.slug not in self.env.found_docs:
            return [words], []
        xref = addnodes.pending_xref(
            "", words, refdomain="std", reftype="doc", refexplicit=True,
            reftarget="/" + chapter.slug, refwarn=True,
            refdoc=self.env.docname)
        return [xref], []


# The numbers ------------------------------------------------------------------

def shifted(number, chapter):
    return number and (chapter.number,) + tuple(number[1:])


def number_as_manifest(app, env):
    """Sphinx counts the chapters that are there; the manifest knows better."""
    for chapter in written(env):
        slug = chapter.slug
        for table in (env.toc_secnumbers.get(slug, {}),
                      *env.toc_fignumbers.get(slug, {}).values()):
            for key, number in table.items():
                table[key] = shifted(number, chapter)
        for node in (env.titles[slug],
                     *env.tocs[slug].findall(nodes.reference)):
            node["secnumber"] = shifted(node.get("secnumber"), chapter)
    return []


def read_all_when_files_come_or_go(app, env, added, changed, removed):
    return env.found_docs if added or removed else []


def tell_latex(app, doctree):
    """The number of a chapter, the title of its part, and the end matter."""
    docname = app.env.docname
    tex = {"epilogue": r"\tfback"}.get(docname, "")
    chapter = app.chapters.get(docname)
    if chapter:
        here = written(app.env)
        tex = r"\setcounter{chapter}{%d}" % (chapter.number - 1)
        if opens_part(here, chapter):
            tex = r"\part{%s}" % chapter.part + tex
        if chapter is here[0]:
            tex = r"\tfmain" + tex
    if tex:
        doctree.insert(0, nodes.raw("", tex + "\n", format="latex"))


# What the theme shows ---------------------------------------------------------

def entry(app, docname):
    """A line of the contents."""
    return {"slug": docname, "title": app.env.titles[docname].astext(),
            "chapter": app.chapters.get(docname)}


def tell_theme(app, pagename, templatename, context, doctree):
    here = [entry(app, c.slug) for c in written(app.env)]
    context["chapter"] = app.chapters.get(pagename)
    context["parts"] = [
        [e for e in here if e["chapter"].part == part]
        for part in dict.fromkeys(e["chapter"].part for e in here)]
    context["abstract"] = functools.partial(abstract, app)


def abstract(app, docname):
    """What a chapter's opening is about, as HTML."""
    words = app.env.abstracts.get(docname)
    return app.builder.render_partial(words)["fragment"] if words else ""


def begin(app):
    app.chapters = chapters(Path(app.srcdir) / "chapters")
    if not hasattr(app.env, "abstracts"):
        app.env.abstracts = {}


def setup(app):
    app.add_directive("book-contents", ContentsDirective)
    app.add_role("chapter", ChapterRole())
    app.connect("builder-inited", begin)
    app.connect("env-get-outdated", read_all_when_files_come_or_go)
    app.connect("env-get-updated", number_as_manifest, priority=600)
    app.connect("doctree-read", tell_latex)
    app.connect("html-page-context", tell_theme)
    return {"version": "1", "parallel_read_safe": False}
