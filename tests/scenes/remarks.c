// What is said of files that were read.
#include "scenes/remarks.h"

#include "support/meshes.h"
#include "support/program.h"
#include "support/support.h"

#include <stdio.h>

#define SQUARE "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"

/// Remarks on texts, in files of these names, as they are on standard error.
static const char *remarks_on(int count, const char *const text[])
{
    ck_assert(freopen("err", "w", stderr) != NULL);
    for (int i = 0; i < count; i++) {
        tf_mesh_file file = good_mesh(text[i]);
        tf_remarks_print(&file);
        tf_mesh_file_free(&file);
    }
    fflush(stderr);
    return file_text("err");
}

START_TEST(files_of_triangles_need_no_remark)
{
    ck_assert_str_eq(
        remarks_on(1, (const char *[]){"v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n"}),
        "");
}
END_TEST

START_TEST(polygons_are_told_once)
{
    ck_assert_str_eq(
        remarks_on(2, (const char *[]){SQUARE, SQUARE}),
        "tanglefree: mesh: 1 face with more than three corners is "
        "triangulated; so in further files, of which nothing is said\n");
}
END_TEST

START_TEST(polygons_are_counted)
{
    ck_assert_str_eq(
        remarks_on(1, (const char *[]){SQUARE "f 1 2 4\nf 4 3 2 1\n"}),
        "tanglefree: mesh: 2 faces with more than three corners are "
        "triangulated; so in further files, of which nothing is said\n");
}
END_TEST

#define MSH(elements)                                                          \
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n"      \
    "3 0 1 0\n4 0 0 1\n$EndNodes\n$Elements\n" elements "$EndElements\n"

START_TEST(elements_that_were_left_out_are_counted)
{
    static const char all[] =
        MSH("5\n1 15 0 1\n2 1 0 1 2\n3 2 0 1 2 3\n4 4 0 1 2 3 4\n5 1 0 2 3\n");
    ck_assert_str_eq(
        remarks_on(
            3, (const char *[]){MSH("2\n1 15 0 1\n3 2 0 1 2 3\n"), all, all}),
        "tanglefree: mesh: what is no surface is left out: 2 lines and 1 "
        "volume; so in further files, of which nothing is said\n");
}
END_TEST

#define FACET(a, b, c)                                                         \
    "facet\nouter loop\nvertex " a "\nvertex " b "\nvertex " c                 \
    "\nendloop\nendfacet\n"
#define GOOD FACET("0 0 0", "1 0 0", "0 1 0")
#define FLAT FACET("0 0 0", "0 1 0", "0 0 0")

START_TEST(flat_triangles_are_counted)
{
    ck_assert_str_eq(
        remarks_on(3, (const char *[]){"solid\n" GOOD "endsolid\n",
                                       "solid\n" GOOD FLAT "endsolid\n",
                                       "solid\n" GOOD FLAT FLAT "endsolid\n"}),
        "tanglefree: mesh: 1 triangle with two corners at one position is left "
        "out; so in further files, of which nothing is said\n");
}
END_TEST

START_TEST(several_flat_triangles_are_counted)
{
    ck_assert_str_eq(
        remarks_on(1, (const char *[]){"solid\n" GOOD FLAT FLAT "endsolid\n"}),
        "tanglefree: mesh: 2 triangles with two corners at one position are "
        "left out; so in further files, of which nothing is said\n");
}
END_TEST

START_TEST(a_run_tells_it_on_standard_error)
{
    make_file("a\tb", SQUARE);
    expect(run("$tf detect a* a* a*"), 0,
           "step,kind,a,b,c,d,toi_lo,toi_hi,nx,ny,nz,normal_velocity,case\n",
           "tanglefree: a\\x09b: 1 face with more than three corners is "
           "triangulated; so in further files, of which nothing is said\n");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("scenes/remarks");
    TCase *remarks = tcase_create("remarks");
    tcase_add_checked_fixture(remarks, enter_folder, leave_folder);
    tcase_add_test(remarks, files_of_triangles_need_no_remark);
    tcase_add_test(remarks, polygons_are_told_once);
    tcase_add_test(remarks, polygons_are_counted);
    tcase_add_test(remarks, elements_that_were_left_out_are_counted);
    tcase_add_test(remarks, flat_triangles_are_counted);
    tcase_add_test(remarks, several_flat_triangles_are_counted);
    tcase_add_test(remarks, a_run_tells_it_on_standard_error);
    suite_add_tcase(suite, remarks);
    return suite;
}
