"""Compare kept pictures with ones drawn anew:
python3 tests/figures/same_pictures.py NEW KEPT

Each PNG of the folder NEW must have the same size in KEPT, and nearly the same
pixels: libraries of other versions may round the edges of letters otherwise.
"""
import struct
import sys
import zlib
from pathlib import Path

FAR = 48            # of 255, a visible difference
FEW = 1 / 500       # the part of all pixels that may differ visibly


def chunks(png):
    """The kinds and contents of the chunks of a PNG."""
    at = 8
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        yield kind, png[at + 8:at + 8 + length]
        at += length + 12


def predicted(kind, left, above, corner):
    """What a filter of that kind adds to a byte."""
    if kind == 4:       # whichever is nearest to left + above - corner
        return min((abs(above - corner), 0, left),
                   (abs(left - corner), 1, above),
                   (abs(left + above - 2 * corner), 2, corner))[2]
    return (0, left, above, (left + above) // 2)[kind]


def pixels(png):
    """Width, bytes a pixel and the rows of a PNG of 8 bits a channel."""
    parts = list(chunks(png))
    width, _, depth, color, *_, interlaced = struct.unpack(
        ">IIBBBBB", parts[0][1])
    if depth != 8 or color not in (2, 6) or interlaced:
        raise ValueError("not a plain PNG in red, green and blue")
    size = 3 if color == 2 else 4
    data = zlib.decompress(b"".join(text for kind, text in parts
                                    if kind == b"IDAT"))
    rows, above = [], bytearray(size * (width + 1))
    for start in range(0, len(data), size * width + 1):
        kind, row = data[start], bytearray(size)    # a pixel before the first
        for i, byte in enumerate(data[start + 1:start + 1 + size * width]):
            row.append(byte + predicted(kind, row[i], above[i + size],
                                        above[i]) & 255)
        rows.append(row)
        above = row
    return width, size, rows


def fault(new, kept):
    """What is wrong with a kept picture; None if nothing is."""
    if not kept.exists():
        return "is missing"
    width, size, rows = pixels(new.read_bytes())
    kept_width, kept_size, kept_rows = pixels(kept.read_bytes())
    if (width, size, len(rows)) != (kept_width, kept_size, len(kept_rows)):
        return "has another size"
    far = sum(max(abs(a - b) for a, b in zip(row[i:i + 3], other[i:i + 3]))
              > FAR for row, other in zip(rows, kept_rows) if row != other
              for i in range(size, len(row), size))
    if far > FEW * width * len(rows):
        return f"differs in {far} pixels"
    return None


def main(new, kept):
    pictures = sorted(Path(new).glob("*.png"))
    faults = [(kept / p.name, fault(p, kept / p.name)) for p in pictures]
    faults = [(path, text) for path, text in faults if text]
    for path, text in faults:
        print(f"{path} {text}; make draw-readme", file=sys.stderr)
    print(f"{len(pictures)} pictures of README.md, {len(faults)} stale")
    return pictures and not faults


if __name__ == "__main__":
    sys.exit(0 if main(Path(sys.argv[1]), Path(sys.argv[2])) else 1)
