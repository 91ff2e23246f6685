"""The reference: all public names, from the comments of the public headers.

    ```{public-names}
    ```
lists them and then describes them, a section for each group (`@defgroup`) of
the headers, in the order of the headers.  Doxygen has read the comments (the
Makefile runs it) and Breathe makes the entries; a public name in a comment
becomes a link to its entry.

    {c:func}`tf_decide`         "tf_decide()", a link to its entry
    {c:struct}`tf_contact`      and so for c:enum, c:enumerator, c:type, c:var,
                                c:macro, and c:member for `tf_contact.normal`
"""
import re
from xml.etree import ElementTree

from docutils import nodes
from docutils.statemachine import StringList
from sphinx import addnodes
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective

MARK = re.compile(r"\b((?:tf|TF)_\w+)(?:\(\))?|(?<=\d)\^(-?\w+)")
VERBATIM = (addnodes.desc_signature, addnodes.pending_xref, nodes.literal_block)


# What Doxygen has found -------------------------------------------------------

def compounds(folder, kind):
    """What it calls compounds: the groups, the structs or the file."""
    index = ElementTree.parse(folder / "index.xml")
    for entry in index.iterfind(f"compound[@kind='{kind}']"):
        path = folder / (entry.get("refid") + ".xml")
        yield ElementTree.parse(path).find("compounddef")


def names(compound, places):
    """The names that a group or file declares, in the order of their places."""
    found = [e.text for e in compound.iterfind("innerclass")]
    found += [e.findtext("name") for e in compound.iterfind(".//memberdef")]
    return sorted(found, key=places.get)


def places_of_names(folder):
    """The files and lines in which public names are declared."""
    found = {e.findtext("name"): e for kind in ("file", "group")
             for compound in compounds(folder, kind)
             for e in compound.iterfind(".//memberdef")}
    found.update((e.findtext("compoundname"), e)
                 for e in compounds(folder, "struct"))
    where = {name: e.find("location") for name, e in found.items()}
    return {name: (e.get("file"), int(e.get("line")))
            for name, e in where.items()}


def faults(folder, groups):
    """What Doxygen does not complain of."""
    grouped = {name for _, _, found in groups for name in found}
    for name, (file, _) in places_of_names(folder).items():
        if name not in grouped:
            yield f"{file}: {name} is in no group (@addtogroup)"
    for group in compounds(folder, "group"):
        for value in group.iterfind(".//enumvalue"):
            name = value.findtext("name")
            words = "".join(text for part in ("brief", "detailed")
                            for text in value.find(
                                part + "description").itertext())
            if not words.strip():
                yield f"{name} is not documented"


def begin(app):
    """Read the groups: the title, Doxygen's name for it, and the names."""
    folder = app.built / "reference" / "xml"
    places = places_of_names(folder)
    app.groups = [(e.findtext("title"), e.findtext("compoundname"),
                   names(e, places)) for e in compounds(folder, "group")]
    app.groups.sort(key=lambda group: [places[name] for name in group[2][:1]])
    wrong = list(faults(folder, app.groups))
    if wrong:
        raise ExtensionError("\n".join(wrong))


# The text of the entries ------------------------------------------------------

def link(name, words=None):
    code = nodes.literal("", words or name)
    return addnodes.pending_xref(
        "", code, refdomain="c", reftype="any", reftarget=name,
        refexplicit=True, refwarn=True, classes=["name"])


def marked(text, own, plain):
    """The pieces of a text, links for all public names but its `own`."""
    begin = 0
    for found in MARK.finditer(text):
        yield plain(text[begin:found.start()])
        name, power = found.groups()
        if power:
            yield nodes.superscript("", power.replace("-", "\u2212"))
        else:
            yield link(name, found[0]) if name != own else code(found[0])
        begin = found.end()
    yield plain(text[begin:])


def code(words):
    return nodes.literal("", words) if words else nodes.Text("")


def is_verbatim(node, top):
    while node is not top and not isinstance(node, VERBATIM):
        node = node.parent
    return node is not top


def mark_names(entry, own):
    """Make links of names, and powers of numbers like 2^53."""
    for text in list(entry.findall(nodes.Text)):
        if not is_verbatim(text.parent, entry) and MARK.search(text):
            inside = isinstance(text.parent, nodes.literal)
            old = text.parent if inside else text
            old.parent.replace(old, list(marked(
                text, own, code if inside else nodes.Text)))


# The parts of the entries -----------------------------------------------------

def rows(fields):
    """The parameters and the result, each a label and the words for it."""
    for title, body in fields:
        kind, _, name = title.astext().partition(" ")
        if isinstance(body[0], nodes.bullet_list):
            for item in body.findall(nodes.list_item):
                name, _, *words = item[0].children     # a dash between them
                yield code(name.astext()), words
        elif kind == "Param":
            yield code(name), body[0].children
        else:
            yield nodes.emphasis("", title.astext().lower()), body[0].children


def tabulate(fields):
    table = nodes.definition_list()
    for label, words in rows(fields):
        line = nodes.paragraph("", "", *words)
        for direction in list(line.findall(nodes.strong)):
            direction.replace_self(nodes.emphasis(
                "", direction.astext().strip("[]") + ":"))
        table += nodes.definition_list_item(
            "", nodes.term("", "", label), nodes.definition("", line))
    fields.replace_self(nodes.container("", table, classes=["parameters"]))


def gather_values(heading):
    """A box for the values of an enum instead of a heading above them."""
    within = heading.parent
    at = within.index(heading)
    within[at:] = [nodes.container("", *within[at + 1:], classes=["values"])]


def strip(content):
    """Leave out what is plain: headings, and what Doxygen calls the names."""
    for box in list(content.findall(nodes.container)):
        box.replace_self([child for child in box.children
                          if not isinstance(child, nodes.rubric)])
    for words in list(content.findall(nodes.emphasis)):
        if words.astext() == "Values:":
            gather_values(words.parent)
    for target in list(content.findall(nodes.target)):
        target.parent.remove(target)
    for word in list(content.findall(addnodes.desc_sig_keyword)):
        if word.astext() == "enumerator":
            at = word.parent.index(word)
            del word.parent[at:at + 2]
    for parameter in content.findall(addnodes.desc_parameter):
        parameter[:] = [nodes.inline("", "", *parameter.children,
                                     classes=["sig-param"])]
    for fields in list(content.findall(nodes.field_list)):
        tabulate(fields)


def name_of(entry):
    return entry.next_node(addnodes.desc_name).astext()


def index(entry, inside):
    """Index it by its bare name, and a field below its struct."""
    name = name_of(entry)
    if entry["objtype"] == "var" and name != inside:
        name = f"{inside}; {name}"
    mark = entry.parent[entry.parent.index(entry) - 1]
    mark["entries"] = [("single", name, entry[0]["ids"][0], "", None)]


# The page ---------------------------------------------------------------------

class PublicNames(SphinxDirective):
    def run(self):
        self.env.note_dependency(
            str(self.env.app.built / "reference" / "xml" / "index.xml"))
        self.forget()
        groups = self.env.app.groups
        return [self.overview(groups), *map(self.section, groups)]

    def forget(self):
        """Sphinx 5 does not read the values of an enum anew: it takes what
        is left of those of the last time for others of the same name."""
        symbols = self.env.domaindata["c"]["root_symbol"]._children
        symbols[:] = [symbol for symbol in symbols if symbol.declaration]

    def overview(self, groups):
        items = nodes.definition_list()
        for title, _, found in groups:
            if not found:
                continue
            links = [word for name in found
                     for word in (nodes.Text(", "), link(name))]
            items += nodes.definition_list_item(
                "", nodes.term("", title),
                nodes.definition("", nodes.paragraph("", "", *links[1:])))
        return nodes.container("", items, classes=["overview"])

    def section(self, group):
        title, key, found = group
        section = nodes.section("", nodes.title("", title),
                                names=[nodes.fully_normalize_name(title)])
        self.state.document.note_implicit_target(section, section)
        made = nodes.Element()
        self.state.nested_parse(
            StringList(["```{doxygengroup} " + key, ":members:", "```"],
                       "tanglefree.h"), self.content_offset, made)
        content = made.next_node(addnodes.desc_content)
        strip(content)
        section += self.sorted(content.children, found)
        return section

    def sorted(self, made, found):
        """The description of the group, then its entries in order."""
        entries = {name_of(entry): (mark, entry)
                   for mark, entry in zip(made, made[1:])
                   if isinstance(entry, addnodes.desc)}
        assert set(entries) == set(found), set(entries) ^ set(found)
        for node in made:
            own = isinstance(node, addnodes.desc) and name_of(node)
            for part in node.findall(addnodes.desc):
                index(part, own)
            mark_names(node, own)
            if not isinstance(node, (addnodes.desc, addnodes.index)):
                yield node
        for name in found:
            yield from entries[name]


def setup(app):
    app.setup_extension("breathe")
    app.add_directive("public-names", PublicNames)
    app.connect("builder-inited", begin)
    return {"version": "1", "parallel_read_safe": False}
