"""Tests of book/_ext: /usr/bin/python3 tests/book/weave_test.py"""
import struct
import sys
import tempfile
import types
import unittest
from pathlib import Path
from unittest import mock

sys.dont_write_bytecode = True
ROOT = Path(__file__).parents[2]
sys.path[:0] = [str(ROOT / "book/_ext"), str(Path(__file__).parent)]
from docutils import nodes
from docutils.core import publish_doctree
from docutils.parsers.rst import directives
from sphinx import addnodes
import blocks
import drawings
import formulas
import manifest
import manual
import mathml
import measured
import pages
import pages_test
import places
import reference
import reference_test
import sessions
import slides
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

    def test_quotes_a_prototype_without_its_comment(self):
        header = "/// Says it: say(1, 2).\nint say(int a,\n        int b);\n"
        self.assertEqual(weave.span("a.h", header, "say"), (2, 3))
        self.assertIsNone(weave.span("a.h", header, "says"))
        self.assertIsNone(weave.span("a.c", header, "say"))

    def test_quotes_lines_and_fragments(self):
        self.assertEqual(weave.span("a.c", SOURCE, "2-3"), (2, 3))
        self.assertEqual(weave.span("src/a.c", SOURCE, "Add one"), (12, 13))
        self.assertIsNone(weave.span("src/a.c", SOURCE, "Add two"))
        self.assertIsNone(weave.span("a.c", SOURCE, "more"))


class Slides(unittest.TestCase):
    def words(self, *parts):
        return nodes.caption("", "", *(
            nodes.math(part, part) if part[0] == "$" else nodes.Text(part)
            for part in parts))

    def test_sentences_end_before_capitals_and_formulas(self):
        found = slides.sentences(self.words(
            "Left, 1.5 of ", "$x", ". ", "$y", " is (e.g. here) so.\nRight, no?"))
        self.assertEqual(["".join(n.astext() for n in s) for s in found],
                         ["Left, 1.5 of $x. ", "$y is (e.g. here) so.\n",
                          "Right, no?"])

    def test_leads_with_what_fits_or_is_wanted(self):
        words = self.words("One two. Three. Four five six.")
        for room, count, wanted in ((16, None, 2), (1, None, 1), (1, 3, 3)):
            self.assertEqual(len(slides.leading(words, room, count)), wanted)

    def test_much_text_is_set_smaller(self):
        sizes = [slides.size(nodes.container("", nodes.paragraph(
            "", "a" * count))) for count in (100, 400, 800, 1500)]
        self.assertEqual(sizes, list(slides.SIZES))

    def test_copies_have_no_links_and_targets(self):
        link = nodes.paragraph("", "", nodes.target(), nodes.reference(
            "", "Figure 1", refuri="x"))
        copy = slides.unlinked(link)
        self.assertEqual(copy.astext(), "Figure 1")
        self.assertFalse([*copy.findall(nodes.reference),
                          *copy.findall(nodes.target)])
        self.assertTrue([*link.findall(nodes.reference)])


def chunk(kind, content):
    return struct.pack(">I", len(content)) + kind + content + bytes(4)


SHEET = (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", bytes(13)) +
         chunk(b"tEXt", b"film\x0064 32 32 64 3\n0,2,0\n\n1,1,2\n") +
         chunk(b"IDAT", b"tEXt") + chunk(b"IEND", b""))


class Films(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        built = Path(self.folder.name)
        (built / "films").mkdir()
        for theme in drawings.THEMES:
            (built / "films" / f"still-{theme}.png").write_bytes(SHEET)
        self.noted = []
        app = types.SimpleNamespace(built=built, drawing="draw")
        book = types.SimpleNamespace(note=lambda *n: self.noted.append(n))
        self.env = types.SimpleNamespace(
            app=app, note_dependency=lambda name: None,
            get_domain=lambda name: book)

    def controls(self, figure, **options):
        directive = types.SimpleNamespace(
            arguments=[figure], options=options, env=self.env, error=ValueError)
        numbers = {"still": {"film_still": "0.7"}, "fixed": {}}
        with mock.patch.object(drawings, "listed", lambda program: numbers), \
             mock.patch.object(drawings, "numbers", lambda _, f: numbers[f]):
            return drawings.FilmDirective.controls(directive)

    def test_reads_a_sheet(self):
        sheet = Path(self.folder.name, "films", "still-dark.png")
        self.assertEqual(drawings.read_film(sheet), {
            "width": 64, "height": 32, "tile": 32, "columns": 64,
            "frames": ["0,2,0", "", "1,1,2"]})

    def test_refuses_a_sheet_that_lacks_frames(self):
        sheet = Path(self.folder.name, "films", "still-dark.png")
        sheet.write_bytes(SHEET.replace(b"64 3\n", b"64 4\n"))
        with self.assertRaises(ValueError):
            drawings.read_film(sheet)

    def test_begins_at_the_still(self):
        [raw] = self.controls("still")
        text = raw.astext()
        for part in ('max="2" value="1"', "<button", " hidden>",
                     '"sheet":"_images/films/still-light.png"',
                     '"sheet":"_images/films/still-dark.png"'):
            self.assertIn(part, text)
        self.assertEqual(raw["format"], "html")
        self.assertEqual(self.noted, [("film", "still", "fig-still", "still")])

    def test_takes_frames_of_another_figure(self):
        [raw] = self.controls("fixed", frames="still")
        self.assertIn("films/still-light.png", raw.astext())
        self.assertEqual(self.noted, [("film", "still", "fig-fixed", "still")])

    def test_refuses_figures_that_do_not_move(self):
        for figure, options in ("fixed", {}), ("still", {"frames": "none"}):
            with self.assertRaises(ValueError):
                self.controls(figure, **options)


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

    def test_ends_lines_of_output_after_commas(self):
        self.assertEqual(
            sessions.open_at_commas('a,b<span class="go">c,d, e,</span>'),
            'a,b<span class="go">c,<wbr>d, e,</span>')

    def test_runs_where_the_build_is_named_build(self):
        with sessions.lay_out_desk(ROOT, ROOT / "book") as desk:
            real, status = sessions.run(["ls build/chapters Makefile"], desk)
        self.assertEqual((real, status), (["Makefile", "build/chapters"], 0))

    def test_commands_write_nothing_into_the_build(self):
        with tempfile.TemporaryDirectory() as built:
            with sessions.lay_out_desk(ROOT, Path(built)) as desk:
                real, status = sessions.run(
                    ["echo a >build/b; cat build/b"], desk)
            self.assertEqual((real, status), (["a"], 0))
            self.assertEqual(list(Path(built).iterdir()), [])


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
        self.assertEqual(drawings.written(26990.0, ""), "26{,}990")
        self.assertEqual(drawings.written(0.6769, ".2f"), "0.68")
        self.assertEqual(drawings.written(1.5e-7, ""), r"1.5\times 10^{-7}")

    def test_reads_what_was_measured(self):
        rows, head = measured.read(["# machine: A fast one", "# None.",
                                    "name,value,unit", "a,2.5,ns", "a b-c,4,"])
        self.assertEqual((rows, head), ({"a": 2.5, "a b-c": 4},
                                        {"machine": "A fast one"}))

    def test_judges_claims(self):
        rows = {"a": 2.5, "a b-c": 4.0}
        for text, found in (("a b-c - a", 1.5), ("2 * a > a b-c", True),
                            ("a < a b-c < 1.5 * a", False),
                            ("a > 2 and a b-c > 5", False)):
            self.assertEqual(measured.value(text, rows), found)
        for text in "a b", "a-a", "exit()", "a b-c2":
            with self.assertRaises(ValueError):
                measured.value(text, rows)

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
                 '</mrow>'),
                ("<msubsup><mi>a</mi><mn>0</mn><mo>\u2032</mo></msubsup>",
                 '<msubsup><mi>a</mi><mn>0</mn><mpadded voffset="-0.5em" '
                 'height="0.3em"><mo lspace="0em" rspace="0em" '
                 'mathsize="1.4em">\u2032</mo></mpadded></msubsup>')):
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

    def test_entitles_what_the_report_claims(self):
        directives.register_directive("report", blocks.Report)
        box, = publish_doctree(".. report::\n\n   It holds.\n").findall(
            nodes.container)
        self.assertEqual((box["classes"], box.astext()), (
            ["report"], "The report, line by line\n\nIt holds."))

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

    def test_warns_of_a_place_without_number(self):
        domain = object.__new__(places.Standard)
        domain.pages, words = None, nodes.Text("")
        for kind, link, warnings in (("numref", words, 1), ("ref", words, 0),
                                     ("numref", nodes.reference(), 0)):
            with mock.patch.object(places.StandardDomain, "resolve_xref",
                                   return_value=link), \
                    mock.patch.object(places.logger, "warning") as warning:
                domain.resolve_xref(None, "", None, kind, "a", None, words)
            self.assertEqual(warning.call_count, warnings)

    def test_leaves_numbers_out_of_what_is_searched(self):
        text = nodes.paragraph(
            "", "", nodes.Text("See "), nodes.math("", "x"), nodes.Text(" in "),
            addnodes.pending_xref("", nodes.Text("fig-a"), reftype="numref"))
        self.assertEqual(pages.words(text, str.upper), "See X in \u2026")

    def test_writes_formulas_in_plain_letters(self):
        for inside, text in (
                ("<mn>4.9</mn><mo>\u22c5</mo><msup><mn>10</mn><mrow><mo>\u2212"
                 "</mo><mn>324</mn></mrow></msup>",
                 "4.9 \u22c5 10\u207b\u00b3\u00b2\u2074"),
                ("<msubsup><mi>e</mi><mn>0</mn><mo>\u2032</mo></msubsup><mo>="
                 "</mo><mo>\u2212</mo><mi>p</mi>", "e\u2080\u2032 = \u2212p"),
                ("<mfrac><mn>1</mn><mi>n</mi></mfrac><mo>\u2264</mo><msub><mi>a"
                 "</mi><mtext>max</mtext></msub>", "1/n \u2264 a_(max)")):
            self.assertEqual(mathml.plain_text(
                f"<span><math><semantics><mrow>{inside}</mrow></semantics>"
                "</math></span>"), text)

    def test_sets_the_formulas_of_exercises(self):
        for ascii, text in (
                ("from t = 0 to t = 1.", "from $t = 0$ to $t = 1$."),
                ("mid-step (so 0 < t < 1) is",
                 "mid-step (so $0 < t < 1$) is"),
                ("a walk from a to b,\n e0 e1, e1'",
                 "a walk from $a$ to $b$, $e_0 e_1$, $e_1'$"),
                ("below 2^(word - 1) or 2^-53, -1",
                 r"below $2^{\mathtt{word} - 1}$ or $2^{-53}$, $-1$"),
                ("2.5 u (|a| + |b|), x[0] + x[1]",
                 "$2.5 u (|a| + |b|)$, `x[0] + x[1]`"),
                ("every n x n one; `a` in tf_exact",
                 r"every $n \times n$ one; `a` in `tf_exact`"),
                ("    a = b", "    a = b")):
            self.assertEqual(formulas.from_ascii(ascii), text)


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


HEADER = """\
#ifndef TANGLEFREE_H
#define TANGLEFREE_H
#define TF_API /* visible */
#define TF_SIZE 3   // TF_API int tf_not_this(void);
typedef void tf_handler(const char *file, int line);
typedef struct tf_opaque tf_opaque;
typedef enum tf_kind { TF_NONE = 0, TF_SOME, } tf_kind;
typedef struct tf_pair {
    double low, high[2][3];
    int (*compare)(const void *, const void *);
} tf_pair;
TF_API extern const tf_opaque tf_one, tf_two;
TF_API tf_handler *
tf_set(int (*compare)(void), tf_kind kind);
#endif
"""

ENTRY = """\
<dl><dt class="sig sig-object c" id="c.tf_pair">struct tf_pair</dt>
<dd>{}<dl><dt class="sig sig-object c" id="c.tf_pair.low">double low</dt>
<dd><p>{}</p></dd></dl></dd></dl>"""


class Reference(unittest.TestCase):
    def marked(self, text, own=None):
        line = nodes.paragraph("", "", nodes.Text(text), nodes.literal(
            "", "&tf_one"))
        reference.mark_names(line, own)
        return line

    def test_finds_the_names_of_a_header(self):
        self.assertEqual(sorted(reference_test.names(HEADER)), sorted(
            ["TF_SIZE", "tf_handler", "tf_opaque", "tf_kind", "tf_kind.TF_NONE",
             "tf_kind.TF_SOME", "tf_pair", "tf_pair.low", "tf_pair.high",
             "tf_pair.compare", "tf_one", "tf_two", "tf_set"]))

    def test_takes_what_describes_a_field_for_the_fields(self):
        for own, field in ("A pair.", "the low"), ("", "the low"):
            entries = reference_test.Page(ENTRY.format(own, field)).entries
            self.assertEqual(entries, {"c.tf_pair": own,
                                       "c.tf_pair.low": field})

    def test_links_names_in_text_and_in_code(self):
        line = self.marked("See tf_set() and tf_two, below 2^-50. ")
        self.assertEqual([node["reftarget"] for node in line.findall(
            addnodes.pending_xref)], ["tf_set", "tf_two", "tf_one"])
        self.assertEqual([node.astext() for node in line.findall(
            nodes.superscript)], ["\u221250"])
        self.assertEqual(line.astext(), "See tf_set() and tf_two, "
                         "below 2\u221250. &tf_one")

    def test_does_not_link_an_entry_to_itself(self):
        line = self.marked("tf_one is tf_one", "tf_one")
        self.assertFalse(list(line.findall(addnodes.pending_xref)))


MANUAL = r"""
.Dd November 28, 2026
.Dt PAGE 5
.Os
.Sh NAME
.Nm page
.Nd a page
.Sh FILES
Each
.Pa .obj
has
.Ql v ,
and
.Em more .
.Bl -bullet
.It
One,
.Pa two .
.El
.Pp
Last.
.Bl -tag -width Ds
.It OBJ
Text.
.Bd -literal
$ ls  *
a
.Ed
.El
.Bl -column "name" "value"
.It Em name Ta Em value
.It a b Ta Ql c
.El
"""


class Manual(unittest.TestCase):
    def setUp(self):
        with tempfile.NamedTemporaryFile("w", suffix=".5") as page:
            page.write(MANUAL.lstrip())
            page.flush()
            name, files = manual.read(page.name)
        self.heading = "".join(files.find("h1").itertext())
        files.remove(files.find("h1"))
        self.blocks = manual.blocks(files)

    def test_takes_blocks_in_their_order(self):
        self.assertEqual(self.heading, "FILES")
        self.assertEqual([type(block) for block in self.blocks], [
            nodes.paragraph, nodes.bullet_list, nodes.paragraph,
            nodes.definition_list, nodes.table])

    def test_marks_words(self):
        line = self.blocks[0]
        self.assertEqual(line.astext().strip(), "Each .obj has v, and more.")
        self.assertEqual([node.astext() for node in line.findall(
            nodes.literal)], [".obj", "v"])
        self.assertEqual(line.next_node(nodes.emphasis).astext(), "more")

    def test_takes_lists(self):
        self.assertEqual(self.blocks[1].astext().strip(), "One, two.")
        self.assertEqual(self.blocks[2].astext().strip(), "Last.")
        term, text = self.blocks[3][0]
        self.assertEqual(term.astext(), "OBJ")
        self.assertEqual(text[0].astext().strip(), "Text.")
        self.assertEqual(text[1].astext(), "$ ls  *\na")
        self.assertIsInstance(text[1], nodes.literal_block)

    def test_takes_tables(self):
        table = self.blocks[4]
        self.assertEqual([cell.astext() for cell in table.next_node(
            nodes.thead).findall(nodes.entry)], ["name", "value"])
        self.assertEqual([cell.astext() for cell in table.next_node(
            nodes.tbody).findall(nodes.entry)], ["a b", "c"])
        self.assertFalse([*table.findall(nodes.emphasis)])


if __name__ == "__main__":
    unittest.main()
