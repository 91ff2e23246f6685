// Files of a sequence have the same elements, and the triangles of the first.
#include "scenes/same_elements.h"

#include "support/meshes.h"
#include "support/support.h"

#define POINTS "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 2 2\n"

/// Reads a file as the next one after another; a fault of it is kept in its
/// fault.  Free both.
static bool continues(const char *text, const char *before,
                      tf_mesh_file file[2])
{
    file[0] = good_mesh(before);
    file[0].name = "before";
    file[1] = good_mesh(text);
    return tf_continue_sequence(&file[1], &file[0]);
}

static void free_both(tf_mesh_file file[2])
{
    tf_mesh_file_free(&file[0]);
    tf_mesh_file_free(&file[1]);
}

START_TEST(the_same_elements_continue)
{
    tf_mesh_file file[2];
    ck_assert(
        continues(POINTS "f 1 2 3\nl 4 5\n", POINTS "f 1 2 3\nl 4 5\n", file));
    free_both(file);
}
END_TEST

#define BENT "v 0 0 0\nv 0.4 0.6 0\nv 1 1 0\nv 0 1 0\nv 2 2 2\nf 1 2 3 4\n"

START_TEST(polygons_keep_their_triangles)
{
    // The fan around vertex 0 is no triangulation of the second, but stays.
    tf_mesh_file file[2];
    static const int fan[] = {0, 1, 2, 0, 2, 3};
    ck_assert(continues(BENT, POINTS "f 1 2 3 4\n", file));
    expect_triangles(&file[0], 2, fan);
    expect_triangles(&file[1], 2, fan);
    free_both(file);
}
END_TEST

static const struct {
    const char *text, *before;
    long line;
    const char *fault;
} others[] = {
    {POINTS "v 0 0 0\nf 1 2 3\n", POINTS "f 1 2 3\n", -1,
     "6 vertices, but before has 5; all files must have the "
     "same elements"},
    {POINTS "f 2 3 1\n", POINTS "f 1 2 3\n", 6,
     "this triangle is not as in before; all files must have the same elements "
     "in the same order"},
    {POINTS "f 1 2 3\nf 1 2 4 3\n", POINTS "f 1 2 3\nf 1 2 3 4\n", 7,
     "this face is not as in before; all files must have the same elements in "
     "the same order"},
    {POINTS "f 1 2 3\n", POINTS "f 1 2 3\nf 1 2 3\n", -1,
     "1 triangles, but before has 2; all files must have the "
     "same elements"},
    {POINTS "l 1 2\nl 2 1\n", POINTS "l 1 2\nl 1 2\n", 7,
     "this edge is not as in before; all files must have the same elements in "
     "the same order"},
    {POINTS "l 1 2\n", POINTS "l 1 2\nl 1 2\n", -1,
     "1 edges, but before has 2; all files must have the same "
     "elements"},
};

START_TEST(the_first_difference_is_told)
{
    tf_mesh_file file[2];
    ck_assert(!continues(others[_i].text, others[_i].before, file));
    ck_assert_str_eq(file[1].fault->text, others[_i].fault);
    ck_assert_int_eq(file[1].fault->place, others[_i].line);
    free_both(file);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("scenes/same_elements");
    TCase *elements = tcase_create("elements");
    tcase_add_test(elements, the_same_elements_continue);
    tcase_add_test(elements, polygons_keep_their_triangles);
    tcase_add_loop_test(elements, the_first_difference_is_told, 0,
                        sizeof others / sizeof *others);
    suite_add_tcase(suite, elements);
    return suite;
}
