// The command remesh, as a user runs it.

#include "program/command.h"

#include "support/environments.h"
#include "support/program.h"
#include "support/support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SQUARE "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"

static void enter_folder_with_files(void)
{
    enter_folder();
    make_file("square.obj", SQUARE);
    make_file("crossed", "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 1 1 -1\nv 1 1 1\n"
                         "v 9 9 9\nf 1 2 3\nf 4 5 6\n");
}

START_TEST(a_mesh_is_remeshed)
{
    outcome found = run("$tf remesh square.obj -o out.obj --edge 0.25");
    ck_assert_str_eq(found.err, "");
    ck_assert_int_eq(found.status, 0);
    expect_words(found.out, "triangles before: 2\n");
    expect_words(found.out, "rounds: 5\n");
    expect_words(found.out, "\ndistance: ");
    ck_assert_int_gt(occurrences(file_text("out.obj"), "f "), 20);
    expect(run("$tf check --format summary out.obj"), 0,
           "files: 1\nfiles with intersections: 0\nintersections: 0\n", "");
}
END_TEST

START_TEST(a_mesh_goes_from_and_to_a_pipe)
{
    outcome found =
        run("cat square.obj | $tf remesh - -o - -e 9 --rounds 1 --format json");
    ck_assert_int_eq(found.status, 0);
    ck_assert_str_eq(found.out, SQUARE);
    expect_words(found.err, "\"triangles\":2,");
    expect_words(found.err, "\"rounds\":1,");
}
END_TEST

START_TEST(the_ending_chooses_the_format)
{
    outcome found = run("$tf remesh square.obj -o out.ply -e 9");
    ck_assert_int_eq(found.status, 0);
    expect_words(file_text("out.ply"), "ply\n");
}
END_TEST

START_TEST(what_new_triangles_lose_is_said)
{
    make_file("named.obj", "o square\nvt 0 0\n" SQUARE);
    outcome found = run("$tf remesh named.obj -o out.obj -e 9");
    ck_assert_int_eq(found.status, 0);
    ck_assert_str_eq(found.err,
                     "tanglefree: out.obj: without the object names and "
                     "texture coordinates of named.obj\n");
    expect_words(run("$tf remesh named.obj -o - -e 9").err,
                 "tanglefree: standard output: without the object names and "
                 "texture coordinates of named.obj\n");
}
END_TEST

START_TEST(floats_of_stl_are_told)
{
    make_file("third.obj", "v 0 0 0\nv 1 0 0\nv 1 0.1 0\nf 1 2 3\n");
    expect(run("$tf resolve third.obj third.obj -o one.stl 2>&1 >report | "
               "cut -d, -f 1"),
           0, "tanglefree: one.stl: 1 of 9 coordinates are rounded to floats\n",
           "");
    make_file("text.stl",
              "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
              "vertex 1 0 0\nvertex 1 .1 0\nendloop\nendfacet\n"
              "endsolid\n");
    expect(run("$tf remesh text.stl -o two.stl -e 9 2>&1 >report | cut -d, -f "
               "1; cmp one.stl two.stl"),
           0, "tanglefree: two.stl: 1 of 9 coordinates are rounded to floats\n",
           "");
    expect(run("$tf remesh text.stl -o a.pvd -e 9"), 2, "",
           "tanglefree: a.pvd: .pvd is not written; end the name in .obj, "
           ".ply, .stl, .off or .vtp\n");
}
END_TEST

START_TEST(edges_are_kept)
{
    make_file("kept", "# the diagonal, and a corner of it\n0 2\n0\n");
    ck_assert_int_eq(
        run("$tf remesh square.obj -o out.obj -e 0.3 --keep kept").status, 0);
    make_file("none", "1 3\n");
    expect(run("$tf remesh square.obj -o out.obj -e 0.3 --keep none"), 2, "",
           "tanglefree: none: no edge joins the vertices 1 and 3; keep edges "
           "that the mesh has\n");
    expect(run("$tf remesh square.obj -o out.obj -e 0.3 --keep nowhere"), 2, "",
           "tanglefree: nowhere: cannot open: No such file or directory; check "
           "the name\n");
}
END_TEST

START_TEST(lengths_come_from_a_file)
{
    make_file("lengths", "0.1 0.1\n1\n1\n");
    outcome found = run("$tf remesh square.obj -o out.obj --lengths lengths");
    ck_assert_str_eq(found.err, "");
    ck_assert_int_eq(found.status, 0);
    ck_assert_int_gt(occurrences(file_text("out.obj"), "f "), 40);
    make_file("few", "0.1 0.1\n1\n");
    expect(run("$tf remesh square.obj -o out.obj --lengths few"), 2, "",
           "tanglefree: few: the number of lengths is 3, but there are 4 "
           "vertices; write one for each, in their order\n");
}
END_TEST

START_TEST(a_distance_is_kept)
{
    outcome found = run("$tf remesh square.obj -o out.obj --error 0.01");
    ck_assert_str_eq(found.err, "");
    ck_assert_int_eq(found.status, 0);
    const char *most = strstr(found.out, "distance at most: ");
    ck_assert_ptr_nonnull(most);
    ck_assert_double_lt(strtod(strchr(most, ':') + 1, NULL), 1e-12);
    ck_assert_int_eq(occurrences(file_text("out.obj"), "f "), 2);
    expect(run("$tf remesh square.obj -o out.obj --error 1e-20"), 2, "",
           "tanglefree: square.obj: --error 1e-20 can't be kept; give a larger "
           "one\n");
}
END_TEST

/// A square with colors, a label and a linear function of x and y.
#define PROPERTIES                                                             \
    "property uchar red\nproperty double x\nproperty double y\n"               \
    "property double z\nproperty short label\nproperty double f\n"
#define COLORED                                                                \
    "ply\nformat ascii 1.0\nelement vertex 4\n" PROPERTIES                     \
    "element face 2\nproperty list uchar int vertex_indices\n"                 \
    "property uchar flags\nend_header\n255 0 0 0 -5 1\n0 1 0 0 -5 3\n"         \
    "0 1 1 0 -5 -4\n255 0 1 0 -5 -6\n3 0 1 2 9\n3 0 2 3 9\n"

START_TEST(what_vertices_have_is_carried_over)
{
    make_file("colored.ply", COLORED);
    ck_assert_int_eq(run("$tf remesh colored.ply -o out.ply -e 0.3").status, 0);
    const char *text = file_text("out.ply");
    expect_words(text, PROPERTIES "element face");
    const char *row = strstr(text, "end_header\n") + 11;
    int vertices = 0, label, read;
    double red, x, y, z, f;
    sscanf(strstr(text, "element vertex"), "element vertex %d", &vertices);
    ck_assert_int_gt(vertices, 15);
    for (int v = 0; v < vertices; v++, row += read) {
        ck_assert_int_eq(sscanf(row, "%lf %lf %lf %lf %d %lf\n%n", &red, &x, &y,
                                &z, &label, &f, &read),
                         6);
        ck_assert_double_eq_tol(red, 255 * (1 - x), 0.5 + 1e-12);
        ck_assert_double_eq(red, floor(red));
        ck_assert_int_eq(label, -5);
        ck_assert_double_eq_tol(f, 1 + 2 * x - 7 * y, 1e-14);
    }
}
END_TEST

START_TEST(colors_of_obj_are_carried_over)
{
    make_file("colored.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 0 1\nv 1 1 0 0 0 1\n"
                             "v 0 1 0 1 0 0\nf 1 2 3\nf 1 3 4\n");
    ck_assert_int_eq(run("$tf remesh colored.obj -o out.obj -e 0.3").status, 0);
    const char *row = file_text("out.obj");
    int vertices = 0, read;
    double x[6];
    for (; *row == 'v'; row += read, vertices++) {
        ck_assert_int_eq(sscanf(row, "v %lf %lf %lf %lf %lf %lf\n%n", &x[0],
                                &x[1], &x[2], &x[3], &x[4], &x[5], &read),
                         6);
        ck_assert_double_eq_tol(x[3], 1 - x[0], 1e-14);
        ck_assert_double_eq(x[4], 0);
        ck_assert_double_eq_tol(x[5], x[0], 1e-14);
    }
    ck_assert_int_gt(vertices, 15);
}
END_TEST

START_TEST(a_mesh_that_intersects_is_refused)
{
    expect(run("$tf remesh crossed -o made -e 1"), 2, "",
           "tanglefree: crossed: edge 3 4 passes through triangle 0 1 2 "
           "(numbered from 0); move them apart, see 'tanglefree check' for all "
           "such pairs\n");
    ck_assert_int_eq(run("test -e made").status, 1);
}
END_TEST

START_TEST(what_cannot_be_written_is_named)
{
    outcome found = run("$tf remesh square.obj -o no/out -e 1");
    ck_assert_int_eq(found.status, 2);
    expect_words(found.err, "tanglefree: no/out: there is no folder 'no'; ");
}
END_TEST

START_TEST(edges_of_the_wrong_scale_are_refused)
{
    outcome found = run("$tf remesh square.obj -o short -e 1e-9");
    ck_assert_int_eq(found.status, 2);
    expect_words(found.err, "tanglefree: square.obj: --edge 1e-09 would take "
                            "too many triangles; give a longer one");
    ck_assert_int_eq(run("test -e short").status, 1);
}
END_TEST

START_TEST(bad_arguments_are_refused)
{
    expect_usage("remesh -o out -e 1", "tanglefree remesh: one file is req");
    expect_usage("remesh a b -o out -e 1", "tanglefree remesh: one file is");
    expect_usage("remesh square.obj -e 1",
                 "tanglefree remesh: --output OUT is required: where to write "
                 "the new mesh\n");
    expect_usage("remesh square.obj -o out",
                 "tanglefree remesh: --edge L, --lengths FILE or --error D is "
                 "required: how long edges should be\n");
    expect_usage(
        "remesh square.obj -o out -e 0",
        "tanglefree remesh: --edge must be a number above 0, got '0'\n");
    expect_usage(
        "remesh square.obj -o out -e x",
        "tanglefree remesh: --edge must be a number above 0, got 'x'\n");
    expect_usage("remesh square.obj -o out -e 1 --rounds 0",
                 "tanglefree remesh: --rounds must be a whole number from 1 to "
                 "1000, got '0'\n");
    expect_usage("remesh square.obj -o out -e 1 --rounds 1.5",
                 "tanglefree remesh: --rounds must be a whole number from 1 to "
                 "1000, got '1.5'\n");
    expect_usage("remesh square.obj --write out -e 1",
                 "tanglefree remesh: --write is an old spelling; write "
                 "--output\n");
    expect_usage(
        "remesh square.obj -o out -e 1 --output summary",
        "tanglefree remesh: --output summary is an old spelling; write "
        "--format summary, or ./summary for a file of that name\n");
    expect_usage(
        "remesh square.obj -o out -e 1 --format xml",
        "tanglefree remesh: --format must be csv, json or summary, got "
        "'xml'\n");
}
END_TEST

static int run_remesh(int argc, char *argv[])
{
    return tf_command_run(&tf_remesh_command, argc, argv);
}

START_TEST(a_broken_environment_is_refused)
{
    const char *const arguments[] = {
        "tanglefree remesh", "square.obj", "-o", "out", "-e", "1", NULL};
    outcome found = run_broken(_i, run_remesh, arguments);
    ck_assert_int_eq(found.status, 2);
    expect_words(found.err, "floating-point environment");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/remesh_command");
    TCase *tcase = tcase_create("command");
    tcase_add_checked_fixture(tcase, enter_folder_with_files, leave_folder);
    tcase_add_test(tcase, a_mesh_is_remeshed);
    tcase_add_test(tcase, a_mesh_goes_from_and_to_a_pipe);
    tcase_add_test(tcase, the_ending_chooses_the_format);
    tcase_add_test(tcase, what_new_triangles_lose_is_said);
    tcase_add_test(tcase, edges_are_kept);
    tcase_add_test(tcase, lengths_come_from_a_file);
    tcase_add_test(tcase, a_distance_is_kept);
    tcase_add_test(tcase, floats_of_stl_are_told);
    tcase_add_test(tcase, what_vertices_have_is_carried_over);
    tcase_add_test(tcase, colors_of_obj_are_carried_over);
    tcase_add_test(tcase, a_mesh_that_intersects_is_refused);
    tcase_add_test(tcase, what_cannot_be_written_is_named);
    tcase_add_test(tcase, edges_of_the_wrong_scale_are_refused);
    tcase_add_test(tcase, bad_arguments_are_refused);
    tcase_add_loop_test(tcase, a_broken_environment_is_refused, 0,
                        environments());
    suite_add_tcase(suite, tcase);
    return suite;
}
