"""Take the pages apart again: python3 tests/book/pages_test.py FOLDER

The fragments that the pages of FOLDER show, put together by the links among
them, must be the files of src/ byte for byte: all files of the modules of the
chapters that have a page.  What the pages show is all that is used here.
"""
import sys
from html.parser import HTMLParser
from pathlib import Path

ROOT = Path(__file__).parents[2]


class Box:
    """A fragment as a page shows it; a use is ("use", title) in its text."""

    def __init__(self, data):
        self.path = data["data-path"]
        self.first, self.last = int(data["data-first"]), int(data["data-last"])
        self.title, self.pieces = "", [""]

    def uses(self):
        return [piece[1] for piece in self.pieces if isinstance(piece, tuple)]


class Page(HTMLParser):
    """The boxes of a page."""

    def __init__(self, text):
        super().__init__()
        self.boxes, self.inside = [], []
        self.box = None     # the fragment that is being read
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        data = dict(attributes)
        if tag in ("meta", "link", "input", "img", "br", "hr", "wbr"):
            return
        kind = data.get("class") or tag
        self.inside.append(kind)
        if kind.startswith("code-box"):
            self.box = Box(data) if "data-path" in data else None
            self.boxes += [self.box] if self.box else []
        elif self.box and kind == "use" and "pre" in self.inside:
            self.box.pieces += [("use", ""), ""]

    def handle_endtag(self, tag):
        if self.inside and self.inside.pop().startswith("code-box"):
            self.box = None

    def handle_data(self, data):
        if not self.box or "number" in self.inside:
            return
        pieces = self.box.pieces
        if "code-title" in self.inside:
            self.box.title += data.strip("\u27e8\u27e9\u00a0\u2261")
        elif "pre" in self.inside and "use" in self.inside:
            pieces[-2] = ("use", pieces[-2][1] + data)
        elif "pre" in self.inside:
            pieces[-1] += data


def lines_of(box):
    """The lines of a box, each a text or a pair (indentation, title)."""
    line = ""
    for piece in box.pieces:
        if isinstance(piece, tuple):
            yield len(line), piece[1].strip("\u27e8\u27e9")
            line = None
            continue
        *whole, rest = piece.split("\n")
        if line is None:
            whole = whole[1:] if whole else []
        elif whole:
            whole[0] = line + whole[0]
        yield from whole
        line = rest
    if line:
        yield line


def tangle(box, boxes, indent):
    """The lines of the file that a box stands for."""
    lines = [" " * indent + "//: " + box.title]
    for line in lines_of(box):
        if isinstance(line, tuple):
            lines += tangle(boxes[line[1]], boxes, indent + line[0])
        elif not line or line.startswith("#"):
            lines.append(line)
        else:
            lines.append(" " * indent + line)
    return lines + [""] * (box.last - box.first + 1 - len(lines))


def files(boxes):
    """The text of each file of which a fragment is shown."""
    nested = {title.strip("\u27e8\u27e9") for box in boxes.values()
              for title in box.uses()}
    found = {}
    for box in sorted(boxes.values(), key=lambda box: box.first):
        if box.title not in nested:
            lines = found.setdefault(box.path, [])
            lines += tangle(box, boxes, 0)
    return {path: "\n".join(lines) + "\n" for path, lines in found.items()}


def expected(folder):
    """The files of the modules of the chapters that have a page."""
    for line in (ROOT / "book/chapters").read_text().splitlines():
        slug, *modules = line.split() or [""]
        if slug and slug[0].islower() and (folder / f"{slug}.html").exists():
            for module in modules:
                for path in sorted((ROOT / "src").glob(module + ".[ch]")):
                    yield path


def main(folder):
    boxes, faults = {}, []
    for page in sorted(folder.glob("*.html")):
        for box in Page(page.read_text()).boxes:
            if box.title in boxes:
                faults.append(f"{page.name}: shows '{box.title}' again")
            boxes[box.title] = box
    shown, count = files(boxes), 0
    for path in expected(folder):
        count += 1
        name = str(path.relative_to(ROOT / "src"))
        if shown.get(name, "").encode() != path.read_bytes():
            faults.append(f"src/{name}: the pages show something else")
    for fault in faults:
        print(fault, file=sys.stderr)
    print(f"{len(boxes)} fragments on the pages make {count} files of src/, "
          f"{len(faults)} faults")
    return not faults


if __name__ == "__main__":
    sys.exit(0 if main(Path(sys.argv[1])) else 1)
