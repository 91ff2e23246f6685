"""Tests of book/fragments.py: python3 tests/book/fragments_test.py"""
import contextlib
import io
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).parents[2] / "book"))
import fragments

NESTED = """\
//: Add what there is
int sum(void)
{
    //: Start at zero
    int sum = 0;
#ifdef EXTRA

    sum++;
#endif

    //: Add each one
    for (int i = 0; i < 3; i++) {
        //: Add one
        sum += i;
    }
    return sum;
}

//: Say goodbye
int bye;
"""


class Parse(unittest.TestCase):
    def test_tangles_back(self):
        self.assertEqual(
            fragments.tangle(fragments.parse("a.c", NESTED)), NESTED)

    def test_nests_by_indentation(self):
        tops = fragments.parse("a.c", NESTED)
        self.assertEqual(
            [(f.title, f.first, f.last, f.shown())
             for f in fragments.walk(tops)],
            [("Add what there is", 1, 18, 5),
             ("Start at zero", 4, 10, 5),
             ("Add each one", 11, 16, 4),
             ("Add one", 13, 14, 1),
             ("Say goodbye", 19, 20, 1)])

    def test_refuses_a_line_before_the_first(self):
        for text in "int a;\n//: A\n", "\n//: A\n":
            with self.assertRaisesRegex(fragments.Misplaced, r"^a\.c:1: "):
                fragments.parse("a.c", text)

    def test_refuses_a_misspelt_head(self):
        for head in "//:A", "//:  A", "//:", "\t//: A", "//: A ", "//: A\r":
            with self.assertRaisesRegex(fragments.Misplaced, r"^a\.c:3: "):
                fragments.parse("a.c", "//: B\nint b;\n" + head + "\n")


class Check(unittest.TestCase):
    def check(self, **files):
        """Whether all is well with a.c and so on, and all that was printed."""
        with tempfile.TemporaryDirectory() as root:
            for name, text in files.items():
                (Path(root) / (name + ".c")).write_bytes(text.encode())
            said = io.StringIO()
            with contextlib.redirect_stdout(said), \
                    contextlib.redirect_stderr(said):
                well = fragments.check(root)
            return well, said.getvalue().replace(root + "/", "")

    def assert_fault(self, fault, **files):
        well, said = self.check(**files)
        self.assertFalse(well, said)
        self.assertIn(fault, said)

    def test_takes_good_files(self):
        well, said = self.check(a=NESTED, b="//: Do it\nint b;\n")
        self.assertTrue(well, said)
        self.assertEqual(said, "6 fragments in 2 files, 0 faults\n")

    def test_refuses_a_line_outside(self):
        self.assert_fault("a.c:1: a line outside", a="int a;\n")

    def test_refuses_the_same_title_twice(self):
        self.assert_fault("b.c:1: 'Do it' is also the title of a.c:1",
                          a="//: Do it\nint a;\n", b="//: Do it\nint b;\n")

    def test_refuses_what_does_not_tangle_back(self):
        self.assert_fault("a.c:2: does not tangle back", a="//: Do it\nint a;")

    def test_refuses_lines_wider_than_a_page(self):
        self.assert_fault("a.c:2: 83 columns are more than the 82 of a page",
                          a="//: Do it\n" + "/" * 83 + "\n")
        well, said = self.check(a="//: Do it\n" + "/" * 82 + "\n")
        self.assertTrue(well, said)

    def test_refuses_bad_titles(self):
        self.assert_fault("a.c:1: 'do it' does not start", a="//: do it\n1\n")
        self.assert_fault("a.c:1: 'Do it.' ends", a="//: Do it.\n1\n")

    def test_refuses_an_empty_fragment(self):
        self.assert_fault("a.c:1: 'A' is empty", a="//: A\n\n//: B\nint b;\n")

    def test_refuses_an_empty_folder(self):
        self.assert_fault("no sources")

    def test_tells_long_fragments_and_takes_them(self):
        for lines, told in (25, False), (26, True):
            well, said = self.check(a="//: Do it\n" + "int a;\n" * lines)
            self.assertTrue(well, said)
            self.assertEqual("a.c:1: note: 'Do it' has 26" in said, told)


if __name__ == "__main__":
    unittest.main()
