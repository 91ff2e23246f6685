"""See that the proofs fail where they should: of code that was changed."""

import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).parent.parent.parent
FILTER = "src/arithmetic/filter.c"
CLAMPED = "src/arithmetic/clamped.c"
TIME = "src/intersect/time.c"
DETERMINANTS = "src/fast/determinants.h"
LANES = "src/fast/lanes.h"
SIX = "src/arithmetic/six.c"
VECTOR = "src/geometry/vector.h"

# A script, a change of a file, and what the script must tell then.
CHANGES = [
    ("2x2", FILTER, "(3 + 0x1p-40)", "3", "NOT PROVED"),
    ("3x3", FILTER, "(7 + 0x1p-40)", "7", "NOT PROVED"),
    ("3x3", FILTER, "0x1p-1071", "0x1p-1073", "NOT PROVED"),
    ("2x2", FILTER, "0x1p-1071", "0x1p-1074", "NOT PROVED"),
    ("value", CLAMPED, "(1 + 4 * u)", "(1 + 3 * u)", "NOT PROVED"),
    ("value", CLAMPED, "4 * u * fabs", "3 * u * fabs", "NOT PROVED"),
    ("underflow", FILTER, "0x1p961", "0x1p967", "NOT PROVED"),
    ("ratio", TIME, "(6 + 0x1p-40", "(6", "NOT PROVED"),
    ("ratio", TIME, "0x1p-1070", "0x1p-1072", "NOT PROVED"),
    ("2x2", FILTER, "fabs(down) + fabs(up)", "fabs(down - up)",
     "the code has no"),
    ("3x3", FILTER, "zx - xz", "zx + xz", "the code has no"),
    ("lanes", LANES, "(256 *", "(242 *", "NOT PROVED"),
    ("lanes", DETERMINANTS, "0x1p-300", "0x1p-350", "NOT PROVED"),
    ("lanes", VECTOR, "a.x[0] * b.x[1] - a.x[1] * b.x[0]", "a.x[0] * b.x[1]",
     "the code has no"),
    ("lanes", VECTOR, " + a.x[2] * b.x[2];", ";", "the code has no"),
    ("six", SIX, "(192 *", "(168 *", "NOT PROVED"),
    ("six", SIX, "0x1p-900", "0x1p-1022", "NOT PROVED"),
    ("six", SIX, "a[0] * b[1] - a[1] * b[0]", "a[0] * b[1]",
     "the code has no"),
    ("2x2", "tests/proofs/2x2.gappa", "up * (1 - keep2)", "up * keep2",
     "a rule is no identity"),
    ("3x3", "tests/proofs/3x3.gappa", "not (7 + 0x1p-48)", "not (7 + 0x1p-47)",
     "NOT SO"),
]


def prove_changed(tree, script, file, old, new):
    """What a script tells after a change, and whether it passes."""
    path = tree / file
    text = path.read_text()
    assert old in text, old
    path.write_text(text.replace(old, new))
    run = subprocess.run([sys.executable, tree / "tests/proofs/prove.py",
                          script], capture_output=True, text=True)
    path.write_text(text)
    return run.stdout, run.returncode == 0


def main():
    with tempfile.TemporaryDirectory() as folder:
        tree = pathlib.Path(folder)
        for part in "src", "tests/proofs":
            shutil.copytree(ROOT / part, tree / part)
        for *change, expected in CHANGES:
            told, passed = prove_changed(tree, *change)
            if passed or expected not in told:
                sys.exit(f"not refused: {change}\n{told}")
    print(f"refused: {len(CHANGES)} changes of the code and the proofs")


if __name__ == "__main__":
    main()
