"""What the pages have beside the text: the search.

build/book/html/search.html finds words without a server: the text of all
sections is in a script, search-index.js.
"""
import json
from pathlib import Path

from docutils import nodes


LEFT_OUT = (nodes.section, nodes.title, nodes.math_block, nodes.literal_block,
            nodes.raw, nodes.comment)


def words(node):
    """The text of a section; dots stand for formulas, citations and numbers
    of figures and the like."""
    if isinstance(node, nodes.Text):
        return node.astext()
    if isinstance(node, LEFT_OUT):
        return ""
    if isinstance(node, nodes.math) or node.get("refdomain") == "cite" or (
            node.get("reftype") in ("numref", "eq")):
        return "\u2026"
    gap = "" if isinstance(node, (nodes.TextElement, nodes.Inline)) else " "
    return gap.join(words(child) for child in node.children)


def sections(app, docname):
    """For each section: its page, anchor, number, title and text."""
    numbers = app.env.toc_secnumbers.get(docname, {})
    for section in app.env.get_doctree(docname).findall(nodes.section):
        top = isinstance(section.parent, nodes.document)
        anchor = "" if top else "#" + section["ids"][0]
        number = ".".join(map(str, numbers.get(anchor) or ()))
        text = " ".join(" ".join(map(words, section.children)).split())
        yield [docname, anchor, number, section.next_node(
            nodes.title).astext(), text]


def write_index(app, error):
    if error is None and app.builder.name == "html":
        found = [section for docname in sorted(app.env.found_docs)
                 for section in sections(app, docname)]
        text = json.dumps(found, ensure_ascii=False, separators=(",", ":"))
        (Path(app.outdir) / "_static" / "search-index.js").write_text(
            f"const sections = {text};\n")


def search_page(app):
    yield "search", {}, "search.html"


def without_own_search(app):
    app.builder.search = False


def setup(app):
    app.connect("builder-inited", without_own_search)
    app.connect("html-collect-pages", search_page)
    app.connect("build-finished", write_index)
    return {"version": "1", "parallel_read_safe": True}
