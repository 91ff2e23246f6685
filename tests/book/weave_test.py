"""Tests of book/_ext: /usr/bin/python3 tests/book/weave_test.py"""
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).parents[2]
sys.path[:0] = [str(ROOT / "book/_ext"), str(Path(__file__).parent)]
from docutils import nodes
from sphinx import addnodes
import blocks
import drawings
import manifest
import mathml
import pages
import pages_test
import sessions
import weave
from fragments import parse, walk

SOURCE = """\
//: Add what there is
int sum(void)
{
    //: Start at zero
    int sum = 0;
#ifdef EXTRA
    sum++;
#endif

    //: Add each one
    while (more()) {
        //: Add one
        sum++;
    }
    return sum;
}

/// Says it.
static int say(int a,
               int b)
{
    return a;
}

START_TEST(adds)
{
    say(1, 2);
}
END_TEST
"""


def page(fragments):
    """A page that shows these fragments, as the theme writes it."""
    def code(fragment):
        titles = [child.title for child in weave.children(fragment)]
        text = "\n".join(weave.shown_lines(fragment)).rstrip("\n")
        for title in titles:
            text = text.replace(
                f"//: {title}", f'<a class="use">\u27e8{title}\u27e9'
                '<span class="number">1.1</span></a>')
        return text
    return "".join(
        f'<div class="code-box" data-path="{f.path}" data-first="{f.first}" '
        f'data-last="{f.last}"><p class="code-title">\u27e8{f.title}<span '
        f'class="number">1.1</span>\u27e9\u00a0\u2261</p><pre><code>{code(f)}\n'
        '</code></pre></div>' for f in fragments)


class Weave(unittest.TestCase):
    def setUp(self):
        self.fragments = list(walk(parse("a.c", SOURCE)))

    def test_children_stand_as_their_heads(self):
        self.assertEqual(
            list(weave.shown_lines(self.fragments[0]))[:4],
            ["int sum(void)", "{", "    //: Start at zero",
             "    //: Add each one"])

    def test_preprocessor_lines_keep_their_place(self):
        self.assertEqual(list(weave.shown_lines(self.fragments[1])),
                         ["int sum = 0;", "#ifdef EXTRA", "sum++;", "#endif",
                          ""])

    def test_pages_tangle_back(self):
        boxes = {b.title: b for b in pages_test.Page(
            page(self.fragments)).boxes}
        self.assertEqual(pages_test.files(boxes), {"a.c": SOURCE})

    def test_pages_that_differ_do_not_tangle_back(self):
        boxes = {b.title: b for b in pages_test.Page(
            page(self.fragments).replace("return sum", "return 0")).boxes}
        self.assertNotEqual(pages_test.files(boxes), {"a.c": SOURCE})

    def test_quotes_a_function_with_its_comment(self):
        self.assertEqual(weave.span("a.c", SOURCE, "say"), (18, 23))

    def test_quotes_a_test_to_its_end(self):
        self.assertEqual(weave.span("a.c", SOURCE, "adds"), (25, 29))

    def test_quotes_lines_and_fragments(self):
        self.assertEqual(weave.span("a.c", SOURCE, "2-3"), (2, 3))
        self.assertEqual(weave.span("src/a.c", SOURCE, "Add one"), (12, 13))
        self.assertIsNone(weave.span("src/a.c", SOURCE, "Add two"))
        self.assertIsNone(weave.span("a.c", SOURCE, "more"))


class Sessions(unittest.TestCase):
    def test_reads_commands_and_output(self):
        self.assertEqual(
            sessions.commands(["$ a \\", "> b", "out", "$ c"]),
            [(["a \\", "b"], ["out"]), (["c"], [])])

    def test_refuses_output_without_a_command(self):
        with self.assertRaises(ValueError):
            sessions.commands(["out"])

    def test_runs_and_compares(self):
        real, status = sessions.run(["printf 'a\\nb\\n'; exit 3"], ROOT)
        self.assertEqual((real, status), (["a", "b"], 3))
        for expected, agrees in ((["a", "b"], True), (["a"], False),
                                 (["...", "b"], True), (["a", "..."], True),
                                 (["b", "..."], False)):
            self.assertEqual(bool(sessions.agrees(expected, real)), agrees)


class Texts(unittest.TestCase):
    def test_numbers_chapters_and_parts(self):
        found = list(manifest.chapters(ROOT / "book/chapters").values())
        self.assertEqual([c.number for c in found],
                         list(range(1, len(found) + 1)))
        self.assertEqual((found[0].slug, found[0].part_number),
                         ("spacetime", "I"))

    def test_reads_the_task_of_an_exercise(self):
        head, *text = blocks.opening_comment(
            "/* Exercise 2.1.  A sum.\n *\n * Add\n * it.\n *\n"
            " * Hint 1: how?\n */\nint a;\n")
        self.assertEqual(blocks.HEAD.match(head).groups(),
                         ("2", "1", "A sum"))
        self.assertEqual(list(blocks.task(text)), ["Add\nit."])

    def test_writes_numbers(self):
        self.assertEqual(drawings.written(26990.0, ""), "26990")
        self.assertEqual(drawings.written(0.6769, ".2f"), "0.68")
        self.assertEqual(drawings.written(1.5e-7, ""), r"1.5\times 10^{-7}")

    def test_draws_formulas_as_browsers_can(self):
        def drawn(inside):
            return mathml.legible(
                '<span class="katex"><math xmlns="http://www.w3.org/1998/Math/'
                f'MathML"><semantics><mrow>{inside}</mrow></semantics></math>'
                '</span>')[len("<math><mrow>"):-len("</mrow></math>")]
        for before, after in (
                ('<mi mathvariant="double-struck">R</mi>', "<mi>\u211d</mi>"),
                ('<mi mathvariant="bold">x</mi>', "<mi>\U0001d431</mi>"),
                ('<mo fence="true">\u2223</mo>', '<mo fence="true">|</mo>'),
                ("<mo>(</mo><mo>\u2212</mo>",
                 '<mo>(</mo><mo form="prefix">\u2212</mo>'),
                ("<mo>)</mo><mo>\u2212</mo>", "<mo>)</mo><mo>\u2212</mo>"),
                ("<mi>c</mi><mi>det</mi><mo>\u2061</mo><mo>(</mo>",
                 '<mi>c</mi><mspace width="0.167em" /><mi>det</mi>'
                 "<mo>\u2061</mo><mo>(</mo>"),
                ("<msup><mi>a</mi><mo>\u2032</mo></msup>",
                 '<mrow><mi>a</mi><mo lspace="0em" rspace="0em">\u2032</mo>'
                 '</mrow>')):
            self.assertEqual(drawn(before), after)

    def test_ends_formulas_without_a_gap(self):
        drawn = mathml.legible(
            '<span class="katex"><math><semantics><mrow><mi>t</mi><mo>=</mo>'
            '</mrow></semantics></math></span>')
        self.assertEqual(drawn, '<math><mrow><mi>t</mi><mo rspace="0em">='
                                '</mo></mrow></math>')

    def test_glues_to_a_formula_what_touches_it(self):
        math = "<math><mi>a</mi></math>"
        for before, after in (
                (f"in {math} and", f"in {math} and"),
                (f"({math})", f'<span class="glued">({math})</span>'),
                (f"x, {math}<wbr>{math}, y", f"x, {math}<wbr>"
                 f'<span class="glued">{math},</span> y'),
                (f"the {math}-th one",
                 f'the <span class="glued">{math}-th</span> one')):
            self.assertEqual(mathml.glued(before), after)

    def test_breaks_long_formulas_after_relations(self):
        root = mathml.ElementTree.fromstring(
            "<math><mrow><mi>a</mi><mo>=</mo><mo>(</mo><mi>b</mi><mo>,</mo>"
            f"<mi>{'c' * mathml.LONG}</mi><mo>)</mo></mrow></math>")
        self.assertEqual(
            ["".join(line.itertext()) for line in mathml.lines(root)],
            ["a=", "(b," + "c" * mathml.LONG + ")"])

    def test_goes_on_after_code_with_a_small_letter(self):
        def goes_on(*children):
            nodes.section("", *children)
            return blocks.goes_on(children[-1])

        code = nodes.literal_block("", "make")
        self.assertTrue(goes_on(code, nodes.paragraph("", "builds it.")))
        self.assertFalse(goes_on(code, nodes.paragraph("", "Then more.")))
        self.assertFalse(goes_on(nodes.paragraph("", "a"),
                                 nodes.paragraph("", "b")))
        self.assertFalse(goes_on(nodes.title("", "A"),
                                 nodes.paragraph("", "b")))
        self.assertFalse(goes_on(nodes.paragraph("", "b")))

    def test_finds_notes_without_text_or_reference(self):
        self.assertEqual(
            blocks.loose_notes("A[^a] b[^b]\n\n[^a]: Yes.\n[^c]: No.\n"),
            [("b", False, 1), ("c", True, 4)])

    def test_drops_the_paragraph_of_an_empty_cell(self):
        empty = nodes.entry("", nodes.paragraph())
        full = nodes.entry("", nodes.paragraph("", "1"))
        blocks.drop_empty(None, nodes.row("", empty, full))
        self.assertEqual((len(empty), len(full)), (0, 1))

    def test_leaves_numbers_out_of_what_is_searched(self):
        text = nodes.paragraph(
            "", "", nodes.Text("See "), nodes.math("", "x"), nodes.Text(" in "),
            addnodes.pending_xref("", nodes.Text("fig-a"), reftype="numref"))
        self.assertEqual(pages.words(text), "See \u2026 in \u2026")


class Print(unittest.TestCase):
    """Code in LaTeX."""

    def latex(self, code):
        class Translator:
            class highlighter:
                @staticmethod
                def highlight_block(code, language):
                    return f"\\begin\n{code}\n\\end"

        return weave.latex_code(Translator, {
            "code": code, "path": "a.c", "uses": []})

    def test_ends_pages_at_blank_lines(self):
        self.assertEqual(
            self.latex("a\nb\nc\n\nd\ne\nf").split("\n"),
            ["a", "b", "c", r"\end{Verbatim}", r"\tfblank", weave.VERBATIM,
             "d", "e", "f"])
        for code in "a\nb\n\nc\nd\ne", "a\nb\nc\n\nd\ne":
            self.assertEqual(self.latex(code), code)

    def test_leaves_the_heads_of_a_quotation(self):
        head = r"\PYG{c+c1}{//: Start}"
        self.assertEqual(self.latex(head + "\nint a;"), head + "\nint a;")


if __name__ == "__main__":
    unittest.main()
