#!/usr/bin/env python3
"""Fragments: the named pieces of src/ that the book shows, each exactly once.

A fragment begins at a comment line `//: Title` and runs to the next such line
of the same or a lesser indentation, to the first line of code indented less,
or to the end of the file.  So fragments nest by indentation.  The title is the
key: no two fragments of src/ have the same.

    python3 book/fragments.py check src

sees that every line of src/ belongs to a fragment and fits on a page, that the
fragments tangle back to the files byte for byte, and that titles are well
formed and unique.
"""
import re
import sys
from dataclasses import dataclass, field
from pathlib import Path

HEAD = re.compile(r"^( *)//: (\S|\S.*\S)$")
LONG = 25       # lines; a longer fragment is hard to explain in one go
WIDE = 82       # columns; a wider line has to be scrolled in the book's pages


class Misplaced(Exception):
    """A line where it must not be; says FILE:LINE: what is wrong."""

    def __init__(self, path, line, text):
        super().__init__(f"{path}:{line}: {text}")


@dataclass
class Fragment:
    title: str
    path: str
    indent: int
    first: int      # the line of the head, from 1
    last: int = 0   # the last line, inclusive
    parts: list = field(default_factory=list)   # lines and child Fragments

    def lines(self):
        """The head and every line, children expanded: what a compiler sees."""
        yield " " * self.indent + "//: " + self.title
        for part in self.parts:
            if isinstance(part, Fragment):
                yield from part.lines()
            else:
                yield part

    def shown(self):
        """How many lines the book shows: a child is one, blanks at the end
        are none."""
        lines = ["child" if isinstance(part, Fragment) else part
                 for part in self.parts]
        while lines and not lines[-1].strip():
            lines.pop()
        return len(lines)


def parse(path, text):
    """The top-level fragments of one source file."""
    tops, stack = [], []
    lines = text.split("\n")
    if lines[-1] == "":
        lines.pop()     # what follows the last newline is no line
    for number, line in enumerate(lines, 1):
        head = HEAD.match(line)
        if line.lstrip().startswith("//:") and not head:
            raise Misplaced(path, number, "a head is '//: Title', with no other spaces")
        indent = len(line) - len(line.lstrip(" "))
        # Blank lines and preprocessor lines have no indentation of their own.
        code = line.strip() and not line.startswith("#")
        while stack and (head and indent <= stack[-1].indent
                         or code and indent < stack[-1].indent):
            stack.pop().last = number - 1
        if head:
            new = Fragment(head[2], path, indent, number)
            (stack[-1].parts if stack else tops).append(new)
            stack.append(new)
        elif stack:
            stack[-1].parts.append(line)
        else:
            raise Misplaced(path, number, "a line outside all fragments")
    for fragment in stack:
        fragment.last = len(lines)
    return tops


def tangle(tops):
    """The text of the source file that these top-level fragments make."""
    return "".join(line + "\n" for top in tops for line in top.lines())


def walk(fragments):
    """All fragments in reading order, children after their parents."""
    for fragment in fragments:
        yield fragment
        yield from walk(p for p in fragment.parts if isinstance(p, Fragment))


def sources(root):
    return sorted(Path(root).rglob("*.[ch]"))


def read(path):
    """The text of a file, its line ends as they are."""
    return path.read_bytes().decode()


def load(root):
    """All fragments below root, by title."""
    return {fragment.title: fragment for path in sources(root)
            for fragment in walk(parse(str(path), read(path)))}


# The check --------------------------------------------------------------------

def faults_of_fragment(fragment, seen):
    """What is wrong with one fragment; `seen` has those before, by title."""
    where, title = f"{fragment.path}:{fragment.first}", fragment.title
    if title in seen:
        other = seen[title]
        yield (f"{where}: '{title}' is also the title of "
               f"{other.path}:{other.first}")
    if not title[0].isupper():
        yield f"{where}: '{title}' does not start with a capital letter"
    if title[-1] in ".:;":
        yield f"{where}: '{title}' ends with a '{title[-1]}'"
    if fragment.shown() == 0:
        yield f"{where}: '{title}' is empty"


def faults_of_file(path, seen):
    """What is wrong with one file; its fragments are added to `seen`."""
    text = read(path)
    try:
        tops = parse(str(path), text)
    except Misplaced as misplaced:
        yield str(misplaced)
        return
    for number, line in enumerate(text.splitlines(), 1):
        if len(line) > WIDE:
            yield (f"{path}:{number}: {len(line)} columns are more than the "
                   f"{WIDE} of a page")
    before, after = text.splitlines(True), tangle(tops).splitlines(True)
    if before != after:
        same = [a == b for a, b in zip(before, after)]
        line = (same + [False]).index(False) + 1
        yield f"{path}:{line}: does not tangle back to itself"
    for fragment in walk(tops):
        yield from faults_of_fragment(fragment, seen)
        seen.setdefault(fragment.title, fragment)


def check(root):
    """Print what is wrong and what is long; return whether all is well."""
    paths, seen = sources(root), {}
    faults = [fault for path in paths for fault in faults_of_file(path, seen)]
    if not paths:
        faults.append(f"{root}: no sources here")
    for fault in faults:
        print(fault, file=sys.stderr)
    for fragment in seen.values():
        if fragment.shown() > LONG:
            print(f"{fragment.path}:{fragment.first}: note: '{fragment.title}' "
                  f"has {fragment.shown()} lines")
    print(f"{len(seen)} fragments in {len(paths)} files, {len(faults)} faults")
    return not faults


if __name__ == "__main__":
    if len(sys.argv) != 3 or sys.argv[1] != "check":
        sys.exit("usage: python3 book/fragments.py check FOLDER")
    sys.exit(0 if check(sys.argv[2]) else 1)
