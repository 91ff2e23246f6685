"""Manual pages, as mandoc reads them.

    ```{manual-page} tanglefree-formats.5
    ```
is the text of the page in src/package/manual: what its section DESCRIPTION says,
and then a section for each other one, without NAME and SEE ALSO.
"""
import re
import subprocess
from xml.etree import ElementTree

from docutils import nodes
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective

INLINE = {"code": nodes.literal, "i": nodes.emphasis, "b": nodes.strong}
LEFT_OUT = ("NAME", "SEE ALSO")


def read(path):
    """The sections of a page."""
    done = subprocess.run(["mandoc", "-T", "html", "-O", "fragment", path],
                          capture_output=True, text=True)
    if done.returncode:
        raise ExtensionError(f"mandoc cannot read {path}: {done.stderr}")
    # What is quoted has letters of its own.
    text = re.sub(r"&#x2018;(<code.*?</code>)&#x2019;", r"\1", done.stdout)
    return ElementTree.fromstring(f"<page>{text}</page>").iter("section")


# Text -------------------------------------------------------------------------

def plain(text):
    return nodes.Text(re.sub(r"\s+", " ", text or ""))


def words(element):
    """What is inside: the text, and what is marked in it."""
    found = [plain(element.text)]
    for child in element:
        found += marked(child)
        found.append(plain(child.tail))
    return found


def marked(child):
    """A part of a line: a path and what is typed are code."""
    if child.get("class") == "Pa":
        return [nodes.literal("", child.text)]
    make = INLINE.get(child.tag)
    return [make("", "", *words(child))] if make else words(child)


# Blocks -----------------------------------------------------------------------

def blocks(element):
    """What is inside, where lines without a paragraph become one."""
    found, line = [], [plain((element.text or "").lstrip())]
    for child in element:
        make = BLOCKS.get(child.tag)
        if make:
            found += [paragraph(line), make(child)]
            line = [plain((child.tail or "").lstrip())]
        else:
            line += [*marked(child), plain(child.tail)]
    found.append(paragraph(line))
    return [block for block in found if block is not None]


def paragraph(line):
    made = nodes.paragraph("", "", *line)
    return made if made.astext().strip() else None


def bullets(element):
    return nodes.bullet_list("", *(
        nodes.list_item("", *blocks(item)) for item in element.iter("li")))


def definitions(element):
    made = nodes.definition_list()
    for term, text in zip(element.iter("dt"), element.iter("dd")):
        made += nodes.definition_list_item(
            "", nodes.term("", "", *words(term)),
            nodes.definition("", *blocks(text)))
    return made


def row(element):
    return nodes.row("", *(nodes.entry("", nodes.paragraph("", "", *words(cell)))
                           for cell in element.iter("td")))


def table(element):
    """The first row is the heading."""
    head, *body = map(row, element.iter("tr"))
    for mark in list(head.findall(nodes.emphasis)):
        mark.replace_self(nodes.Text(mark.astext()))
    columns = [nodes.colspec(colwidth=1) for _ in head]
    group = nodes.tgroup("", *columns, nodes.thead("", head),
                         nodes.tbody("", *body), cols=len(columns))
    return nodes.table("", group)


def session(element):
    text = element.findtext(".//pre").strip("\n")
    return nodes.literal_block(text, text, language="console",
                               classes=["session"])


BLOCKS = {"p": lambda element: paragraph(words(element)), "ul": bullets,
          "dl": definitions, "table": table, "div": session}


# The page ---------------------------------------------------------------------

class ManualPage(SphinxDirective):
    required_arguments = 1

    def run(self):
        path = self.env.app.root / "src" / "package" / "manual" / \
            self.arguments[0]
        self.env.note_dependency(str(path))
        return [node for section in read(path)
                for node in self.section(section)]

    def section(self, element):
        heading = element.find("h1")
        title = plain("".join(heading.itertext())).astext()
        element.remove(heading)
        if title in LEFT_OUT:
            return []
        if title == "DESCRIPTION":
            return blocks(element)
        title = title.capitalize()
        made = nodes.section("", nodes.title("", title), *blocks(element),
                             names=[nodes.fully_normalize_name(title)])
        self.state.document.note_implicit_target(made, made)
        return [made]


def setup(app):
    app.add_directive("manual-page", ManualPage)
    return {"version": "1", "parallel_read_safe": True}
