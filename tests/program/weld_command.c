// The command weld, as a user runs it.
#include "support/json.h"
#include "support/program.h"
#include "support/support.h"

#include <string.h>

#define SEAM                                                                   \
    "# of two parts\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"                     \
    "v 1 0 0\nv 1 1 0\nv 0 1 0.5\nf 4 5 6\n"

static void enter_folder_with_seam(void)
{
    enter_folder();
    make_file("seam.obj", SEAM);
}

// What is welded --------------------------------------------------------------

START_TEST(a_seam_is_welded)
{
    expect(run("$tf weld seam.obj -o made.obj"), 0,
           "vertices before: 6\nvertices: 5\njoined: 1\nfarthest: 0\n"
           "triangles before: 2\ntriangles: 2\ncollapsed triangles: 0\n"
           "edges before: 0\nedges: 0\ncollapsed edges: 0\n",
           "");
    ck_assert_str_eq(file_text("made.obj"),
                     "# of two parts\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
                     "v 1 1 0\nv 0 1 0.5\nf 2 4 5\n");
}
END_TEST

START_TEST(what_is_near_is_welded)
{
    outcome found = run("$tf weld seam.obj -o made.obj --within 0.5");
    expect_words(found.out, "vertices: 4\njoined: 2\nfarthest: 0.5\n");
    ck_assert_str_eq(file_text("made.obj"),
                     "# of two parts\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
                     "v 1 1 0\nf 2 4 3\n");
    ck_assert_int_eq(run("$tf check seam.obj").status, 1);
    ck_assert_int_eq(run("$tf check made.obj").status, 0);
}
END_TEST

START_TEST(a_mesh_without_seams_stays)
{
    make_file("whole.obj", "# kept\no name\nv 0 0.0 0\nv 1 0 0\nv 0 1 0\n"
                           "vt 1 1\nf 1/1 2/1 3/1\n");
    outcome found = run("$tf weld whole.obj -o made.obj");
    ck_assert_str_eq(found.err, "");
    expect(run("cmp whole.obj made.obj"), 0, "", "");
}
END_TEST

START_TEST(what_cannot_be_kept_is_told)
{
    make_file("curve.obj", SEAM "g one\ncurv 0 1 1 2 4\n");
    expect_words(run("$tf weld curve.obj -o made.obj").err,
                 "tanglefree: made.obj: without the comments, groups and other "
                 "lines of curve.obj\n");
    ck_assert_str_eq(file_text("made.obj"),
                     "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 1 0.5\n"
                     "f 1 2 3\nf 2 4 5\n");
}
END_TEST

START_TEST(faces_that_have_collapsed_already_are_left_out)
{
    make_file("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 2\nf 1 2 3\n");
    expect_words(run("$tf weld bad.obj -o made.obj").out,
                 "collapsed triangles: 1\n");
    ck_assert_str_eq(file_text("made.obj"),
                     "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
}
END_TEST

START_TEST(the_ending_chooses_the_format)
{
    expect(run("$tf weld seam.obj -o made.ply >report 2>said; "
               "head -n 2 made.ply | tail -n 1; "
               "$tf weld seam.obj -o made.off >report 2>said; "
               "head -n 1 made.off; "
               "$tf weld - -o - <seam.obj 2>said | head -n 2"),
           0, "format binary_little_endian 1.0\nOFF\n# of two parts\nv 0 0 0\n",
           "");
}
END_TEST

START_TEST(a_report_may_be_json)
{
    outcome found = run("$tf weld seam.obj -o made.obj --format json");
    ck_assert_msg(!json_fault(found.out), "%s", json_fault(found.out));
    expect_words(found.out,
                 "{\"vertices_before\":6,\"vertices\":5,\"joined\":1,");
    expect(run("$tf weld seam.obj -o made.obj --format csv 2>said | tail -n 1"),
           0, "6,5,1,0,2,2,0,0,0,0\n", "");
}
END_TEST

// But that nobody reads the report is no reason to lose the mesh.
START_TEST(a_closed_pipe_loses_nothing)
{
    make_file("seam.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    run("mkfifo pipe; sleep 5 <pipe & exec 3>pipe; kill $!; wait $!; "
        "$tf weld seam.obj -o kept.obj >&3");
    expect_words(run("cat kept.obj").out, "f 1 2 3\n");
    ck_assert_str_eq(run("ls -A | grep scratch").out, "");
}
END_TEST

// Mistakes --------------------------------------------------------------------

START_TEST(bad_files_are_refused)
{
    make_file("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\n");
    expect(
        run("$tf weld bad.obj -o made.obj; test -e made.obj"), 1, "",
        "tanglefree: bad.obj:5: there is no vertex 4; they are numbered from "
        "1 to 3\n");
    expect(run("$tf weld none.obj -o made.obj"), 2, "",
           "tanglefree: none.obj: cannot open: No such file or directory; "
           "check the name\n");
    expect(run("$tf weld seam.obj -o none/made.obj"), 2, "",
           "tanglefree: none/made.obj: there is no folder 'none'; make it, or "
           "choose another\n");
}
END_TEST

START_TEST(distances_that_are_too_small_are_refused)
{
    expect(run("$tf weld seam.obj -o made.obj --within 1e-16"), 2, "",
           "tanglefree: seam.obj: --within 1e-16 is too small for coordinates "
           "of that size; give at least 8.88178e-16, or none\n");
    ck_assert_int_eq(
        run("$tf weld seam.obj -o made.obj --within 0x1p-50").status, 0);
    expect_usage("weld seam.obj -o made.obj --within 0",
                 "tanglefree weld: --within must be a number above 0, got '0'");
}
END_TEST

START_TEST(wrong_arguments_are_refused)
{
    expect_usage("weld seam.obj",
                 "tanglefree weld: --output OUT is required: where to write "
                 "the welded mesh");
    expect_usage("weld -o made.obj",
                 "tanglefree weld: one file is required: IN");
    expect_usage("weld seam.obj seam.obj -o made.obj",
                 "tanglefree weld: one file is required: IN");
    outcome found = run("$tf weld --help");
    expect_words(found.out, "Usage: tanglefree weld [OPTION...] IN\n");
    expect_words(found.out, "--within=D");
    expect_words(run("$tf --help").out, "  weld       join vertices");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/weld_command");
    TCase *welded = tcase_create("what is welded");
    tcase_add_checked_fixture(welded, enter_folder_with_seam, leave_folder);
    tcase_add_test(welded, a_seam_is_welded);
    tcase_add_test(welded, what_is_near_is_welded);
    tcase_add_test(welded, a_mesh_without_seams_stays);
    tcase_add_test(welded, what_cannot_be_kept_is_told);
    tcase_add_test(welded, faces_that_have_collapsed_already_are_left_out);
    tcase_add_test(welded, the_ending_chooses_the_format);
    tcase_add_test(welded, a_report_may_be_json);
    suite_add_tcase(suite, welded);

    TCase *mistakes = tcase_create("mistakes");
    tcase_add_checked_fixture(mistakes, enter_folder_with_seam, leave_folder);
    tcase_add_test(mistakes, bad_files_are_refused);
    tcase_add_test(mistakes, a_closed_pipe_loses_nothing);
    tcase_add_test(mistakes, distances_that_are_too_small_are_refused);
    tcase_add_test(mistakes, wrong_arguments_are_refused);
    suite_add_tcase(suite, mistakes);
    return suite;
}
