"""Look up every public name: python3 tests/book/reference_test.py FOLDER HEADER...

Each name that a header declares must have an entry with a description in
the reference, a line in the index, and a result in the search, on the pages
of FOLDER.  The headers are read here without Doxygen.
"""
import json
import re
import sys
from html.parser import HTMLParser
from pathlib import Path

PAGE = "reference.html"
HIDDEN = "TF_API"       # marks what is public


def without_comments(text):
    return re.sub(r"//[^\n]*|/\*.*?\*/", " ", text, flags=re.S)


def declared(text):
    """The names of a declaration: of a type, a function or some objects."""
    pointer = re.match(r"[^(]*\(\s*\*\s*(\w+)", text)
    if pointer or "(" in text:
        return [(pointer or re.search(r"(\w+)\s*\(", text))[1]]
    return [re.search(r"(\w+)\s*(\[[^]]*\]\s*)*$", part)[1]
            for part in text.split(",")]


def members(kind, owner, body):
    """The values of an enum or the fields of a struct."""
    if kind == "enum":
        found = [part.split("=")[0].strip() for part in body.split(",")]
    else:
        found = [name for part in body.split(";") if part.strip()
                 for name in declared(part)]
    return [f"{owner}.{name}" for name in found if name]


def names(header):
    """All public names, as the reference calls their entries."""
    text = without_comments(header)
    for guard, name in re.findall(r"(#ifndef \w+\n\s*)?#define (\w+)", text):
        if not guard and name != HIDDEN:
            yield name
    text = re.sub(r"^\s*#.*", "", text, flags=re.M)
    types = r"typedef (enum|struct|union) \w*\s*\{(.*?)\}\s*(\w+);"
    for kind, body, owner in re.findall(types, text, re.S):
        yield owner
        yield from members(kind, owner, body)
    text = re.sub(types, "", text, flags=re.S)
    for declaration in re.findall(rf"(?:typedef|{HIDDEN})\b([^;]*);", text):
        yield from declared(declaration)


class Page(HTMLParser):
    """The entries of a page: the text of each, by its anchor."""

    def __init__(self, text):
        super().__init__()
        self.entries, self.open = {}, []
        self.anchor = None
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        data = dict(attributes)
        if tag == "dt" and data.get("class", "").startswith("sig "):
            self.anchor = data["id"]
            self.entries[self.anchor] = ""
        elif tag == "dd":
            self.open.append(self.anchor)
            self.anchor = None

    def handle_endtag(self, tag):
        if tag == "dd":
            self.open.pop()

    def handle_data(self, data):
        within = [anchor for anchor in self.open if anchor]
        if within and not self.anchor:
            self.entries[within[-1]] += data.strip()


def found_by_search(folder):
    """What the search has, by anchors: title and text."""
    script = (folder / "_static/search-index.js").read_text()
    sections, _ = json.JSONDecoder().raw_decode(script, script.index("["))
    return {anchor.lstrip("#"): (title, text)
            for page, anchor, _, title, text in sections
            if page + ".html" == PAGE}


def faults(header, folder):
    entries = Page((folder / PAGE).read_text()).entries
    index = (folder / "genindex.html").read_text()
    search = found_by_search(folder)
    for name in names(header):
        anchor = "c." + name
        bare = name.split(".")[-1]
        if anchor not in entries:
            yield f"{name} is not in the reference"
            continue
        if not entries[anchor]:
            yield f"{name} has no description in the reference"
        if f'"{PAGE}#{anchor}"' not in index:
            yield f"{name} is not in the index"
        title, text = search.get(anchor, ("", ""))
        if not title.endswith(bare) or not text:
            yield f"{name} is not in the search"


def check(header, folder):
    text = header.read_text()
    found = list(faults(text, folder))
    for fault in found:
        print(fault, file=sys.stderr)
    count = len(list(names(text)))
    print(f"{count} names of {header.name}, {len(found)} faults")
    return count and not found


def main(folder, *headers):
    return all([check(header, folder) for header in headers])


if __name__ == "__main__":
    sys.exit(0 if main(*map(Path, sys.argv[1:])) else 1)
