// The command untangle, as a user runs it.

#include "program/command.h"

#include "support/environments.h"
#include "support/program.h"
#include "support/support.h"

#include <string.h>

#define CROSS                                                                  \
    "# a comment\nv 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n"                        \
    "o other\nv 1 1 -1\nv 1 1 1\nv 9 9 1\nf 4 5 6\n"

static void enter_folder_with_files(void)
{
    enter_folder();
    make_file("cross.obj", CROSS);
    make_file("all", "0 1 2 3 4 5\n");
}

static void expect_clear(const char *path)
{
    char command[200];
    snprintf(command, sizeof command, "$tf check --format summary %s", path);
    expect_words(run("%s", command).out, "\nintersections: 0\n");
}

// Meshes that are cleared -----------------------------------------------------

START_TEST(a_mesh_is_untangled)
{
    outcome found = run("$tf untangle cross.obj -o out.obj");
    ck_assert_str_eq(found.err, "");
    ck_assert_int_eq(found.status, 0);
    expect_words(found.out, "status: untangled\nintersections before: 2\n"
                            "intersections: 0\n");
    expect_words(found.out, "rungs: push return\n");
    expect_clear("out.obj");
}
END_TEST

START_TEST(all_but_positions_is_kept)
{
    run("$tf untangle cross.obj -o out.obj");
    outcome found = run("grep -v '^v' cross.obj >a; grep -v '^v' out.obj >b; "
                        "cmp a b");
    ck_assert_int_eq(found.status, 0);
    expect(run("sed -n 9p cross.obj; sed -n 9p out.obj"), 0,
           "v 9 9 1\nv 9 9 1\n", "");
}
END_TEST

START_TEST(fixed_vertices_stay)
{
    make_file("fixed", "0 1 2 # the first triangle\n");
    outcome found = run("$tf untangle cross.obj -o out.obj -f fixed");
    ck_assert_int_eq(found.status, 0);
    expect(run("head -n 5 cross.obj >a; head -n 5 out.obj | cmp a -"), 0, "",
           "");
    expect_clear("out.obj");
}
END_TEST

START_TEST(a_clear_mesh_comes_back)
{
    make_file("clear.obj", "v 0 0 0\nv 1e0 0 0\nv 0 1 0\nf 1 2 3\n");
    outcome found = run("$tf untangle clear.obj -o out.obj --format csv");
    ck_assert_int_eq(found.status, 0);
    expect_words(found.out, "\nclear,0,0,0,1,0,none,0,0,0,0,");
    expect(run("cmp clear.obj out.obj"), 0, "", "");
}
END_TEST

START_TEST(a_mesh_goes_from_and_to_a_pipe)
{
    outcome found = run("cat cross.obj | $tf untangle - -o - -t 2");
    ck_assert_int_eq(found.status, 0);
    expect_words(found.out, "o other\n");
    expect_words(found.err, "status: untangled\n");
}
END_TEST

START_TEST(curves_in_the_plane_are_untangled)
{
    make_file("curves.obj", "v 0 0\nv 4 0\nv 1 -1\nv 1 1\nl 1 2\nl 3 4\n");
    outcome found = run("$tf untangle curves.obj -o out.obj");
    ck_assert_int_eq(found.status, 0);
    expect_clear("out.obj");
}
END_TEST

// A quad, and a pentagon that it passes through: whoever reads the file divides
// them anew.
START_TEST(polygons_are_clear_as_they_are_read)
{
    make_file("quads.obj",
              "v -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\nf 1 2 3 4\n"
              "v -.3 .1 -1\nv .5 .2 -1\nv .8 .3 0\nv .4 .3 1\nv -.4 .2 1\n"
              "f 5 6 7 8 9\n");
    outcome found = run("$tf untangle quads.obj -o out.obj 2>remarks");
    ck_assert_int_eq(found.status, 0);
    expect(run("$tf check --format summary out.obj 2>remarks"), 0,
           "files: 1\nfiles with intersections: 0\nintersections: 0\n", "");
    expect_words(file_text("out.obj"), "f 5 6 7 8 9\n");
}
END_TEST

// What is left ----------------------------------------------------------------

START_TEST(what_is_left_is_listed)
{
    outcome found = run("$tf untangle cross.obj -o out.obj --fixed all");
    ck_assert_int_eq(found.status, 1);
    expect_words(found.out, "status: tangled\nintersections before: 2\n"
                            "intersections: 2\nbetween fixed: 2\n");
    expect_words(found.out, "\n\nfile,kind,a,b,c,d,e,f\n"
                            "out.obj,edge-triangle,1,2,3,4,5,\n"
                            "out.obj,edge-triangle,3,4,0,1,2,\n");
    expect(run("cmp cross.obj out.obj"), 0, "", "");
    outcome checked = run("$tf check out.obj");
    expect_words(found.out, checked.out);
}
END_TEST

START_TEST(what_is_left_is_an_object)
{
    outcome found =
        run("$tf untangle cross.obj -o out.obj --fixed all --format json");
    ck_assert_int_eq(found.status, 1);
    expect_words(found.out, "{\"status\":\"tangled\",");
    expect_words(found.out, "}\n{\"intersections\":[\n{\"file\":\"out.obj\",");
}
END_TEST

START_TEST(what_is_left_goes_with_the_report)
{
    outcome found = run("$tf untangle cross.obj -o - --fixed all");
    ck_assert_int_eq(found.status, 1);
    ck_assert_str_eq(found.out, CROSS);
    expect_words(found.err, "\n\nfile,kind,a,b,c,d,e,f\n");
}
END_TEST

// Bad input -------------------------------------------------------------------

static const struct {
    const char *arguments, *error;
} bad[] = {
    {"cross.obj", "tanglefree untangle: --output OUT is required: "},
    {"nan.obj -o out.obj",
     "tanglefree: nan.obj:2: 'nan' is not a finite number; "},
    {"cross.obj -o out.obj -f nine",
     "tanglefree: nine:1: there is no vertex 9; they are numbered from 0 to "
     "5\n"},
    {"gone.obj -o out.obj", "tanglefree: gone.obj: cannot open: "},
    {"cross.obj -o nowhere/out.obj",
     "tanglefree: nowhere/out.obj: there is no folder 'nowhere'; "},
    {"cross.obj -o out.obj -t 0", "tanglefree untangle: --threads must be "},
    {"empty.obj -o out.obj", "tanglefree: empty.obj: "},
};

START_TEST(bad_input_changes_nothing)
{
    make_file("nan.obj", "v 0 0 0\nv nan 1 0\nv 0 1 0\nf 1 2 3\n");
    make_file("nine", "9\n");
    make_file("empty.obj", "");
    make_file("out.obj", "as it was\n");
    char command[200];
    snprintf(command, sizeof command, "$tf untangle %s", bad[_i].arguments);
    outcome found = run("%s", command);
    ck_assert_int_eq(found.status, 2);
    ck_assert_str_eq(found.out, "");
    expect_words(found.err, bad[_i].error);
    ck_assert_str_eq(file_text("out.obj"), "as it was\n");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/untangle_command");
    TCase *tcase = tcase_create("untangle");
    tcase_add_checked_fixture(tcase, enter_folder_with_files, leave_folder);
    tcase_add_test(tcase, a_mesh_is_untangled);
    tcase_add_test(tcase, all_but_positions_is_kept);
    tcase_add_test(tcase, fixed_vertices_stay);
    tcase_add_test(tcase, a_clear_mesh_comes_back);
    tcase_add_test(tcase, a_mesh_goes_from_and_to_a_pipe);
    tcase_add_test(tcase, curves_in_the_plane_are_untangled);
    tcase_add_test(tcase, polygons_are_clear_as_they_are_read);
    tcase_add_test(tcase, what_is_left_is_listed);
    tcase_add_test(tcase, what_is_left_is_an_object);
    tcase_add_test(tcase, what_is_left_goes_with_the_report);
    tcase_add_loop_test(tcase, bad_input_changes_nothing, 0,
                        sizeof bad / sizeof *bad);
    suite_add_tcase(suite, tcase);
    return suite;
}
