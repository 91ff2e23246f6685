"""What the pages have beside the text: the search.

build/book/html/search.html finds words without a server: the text of all
sections is in a script, search-index.js.
"""
import contextlib
import json
from pathlib import Path

from docutils import nodes
from sphinx import addnodes

import mathml

LEFT_OUT = (nodes.section, nodes.title, nodes.math_block, nodes.literal_block,
            nodes.raw, nodes.comment, addnodes.desc)


def words(node, plain):
    """The text of a section, its formulas in plain letters; dots stand for
    citations and numbers of figures and the like."""
    if isinstance(node, nodes.Text):
        return node.astext()
    if isinstance(node, LEFT_OUT):
        return ""
    if isinstance(node, nodes.math):
        return plain(node.astext())
    if node.get("refdomain") == "cite" or (
            node.get("reftype") in ("numref", "eq")):
        return "\u2026"
    if isinstance(node, nodes.superscript):
        return "^" + node.astext()
    gap = "" if isinstance(node, (nodes.TextElement, nodes.Inline)) else " "
    return gap.join(words(child, plain) for child in node.children)


def sections(app, docname, plain):
    """For each section: its page, anchor, number, title and text."""
    numbers = app.env.toc_secnumbers.get(docname, {})
    for section in app.env.get_doctree(docname).findall(nodes.section):
        top = isinstance(section.parent, nodes.document)
        anchor = "" if top else "#" + section["ids"][0]
        number = ".".join(map(str, numbers.get(anchor) or ()))
        text = " ".join(words(child, plain) for child in section.children)
        yield [docname, anchor, number, section.next_node(
            nodes.title).astext(), " ".join(text.split())]


def entries(app, docname, plain):
    """The same for each entry of the reference."""
    for entry in app.env.get_doctree(docname).findall(addnodes.desc):
        anchor = entry[0]["ids"][0]
        name = anchor.split(".", 1)[1]      # after the domain
        if entry["objtype"] == "enumerator":
            name = name.split(".")[-1]
        text = " ".join(words(child, plain)
                        for child in entry.children[-1].children)
        yield [docname, "#" + anchor, "", name, " ".join(text.split())]


def write_index(app, error):
    if error is None and app.builder.name == "html":
        with contextlib.closing(mathml.Katex()) as katex:
            found = [section for docname in sorted(app.env.found_docs)
                     for part in (sections, entries)
                     for section in part(app, docname, katex.plain)]
        titles = {docname: app.env.titles[docname].astext()
                  for docname in sorted(app.env.found_docs)}
        (Path(app.outdir) / "_static" / "search-index.js").write_text(
            "".join(f"const {name} = {compact(value)};\n" for name, value in (
                ("sections", found), ("titles", titles))))


def compact(value):
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"))


def search_page(app):
    yield "search", {}, "search.html"


def without_own_search(app):
    app.builder.search = False


def setup(app):
    app.connect("builder-inited", without_own_search)
    app.connect("html-collect-pages", search_page)
    app.connect("build-finished", write_index)
    return {"version": "1", "parallel_read_safe": True}
