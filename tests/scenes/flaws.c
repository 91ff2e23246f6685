#include "scenes/flaws.h"

#include "support/meshes.h"
#include "support/support.h"
#include "surgery/adaptive.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>

// Pairs -----------------------------------------------------------------------

static const struct {
    tf_error error;
    const char *words;
} pairs[] = {
    {{.subject = TF_POINT_EDGE_PAIR, .vertex = {2, 0, 1, -1, -1}},
     "vertex 2 lies on edge 0 1"},
    {{.subject = TF_POINT_TRIANGLE_PAIR, .vertex = {9, 0, 1, 2, -1}},
     "vertex 9 lies on triangle 0 1 2"},
    {{.subject = TF_EDGE_EDGE_PAIR, .vertex = {0, 3, 1, 2, -1}},
     "edge 0 3 meets edge 1 2"},
    {{.subject = TF_EDGE_TRIANGLE_PAIR, .vertex = {8, 9, 0, 1, 2}},
     "edge 8 9 passes through triangle 0 1 2"},
    {{.subject = TF_POINT_TRIANGLE_PAIR, .vertex = {7, 0, 1, INT_MAX, -1}},
     "vertex 7 lies on triangle 0 1 2147483647"},
};

START_TEST(the_pair_is_named)
{
    char right[1000];
    tf_mesh_file file = empty_mesh("start");
    file.first_index = 1; // in rows vertices count from 0 all the same
    tf_error error = pairs[_i].error;
    error.status = TF_START_NOT_CLEAR;
    snprintf(right, sizeof right,
             "%s (numbered from 0) before the step begins; move them apart, "
             "see 'tanglefree check' for all such pairs",
             pairs[_i].words);
    ck_assert(!tf_error_fault(&file, &error));
    ck_assert_str_eq(file.fault->text, right);
    ck_assert_int_lt(file.fault->place, 0);
}
END_TEST

// Defects ---------------------------------------------------------------------

/// A text, the line that is named, and words about it.
static const struct {
    const char *text;
    long place;
    const char *words;
} meshes[] = {
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 3 2\n", 5,
     "the edge from vertex 3 to 2 belongs to no triangle; remove it"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n", 5,
     "another triangle passes the edge from vertex 1 to 2 in the same"},
    {"v 0 0 0\nv 1 0 0\nv 1 1 0\nv -1 0 0\nv -1 -1 0\nf 1 2 3\nf 1 4 5\n", 1,
     "the triangles at vertex 1 form more than one ring or fan"},
    {"v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", 4,
     "the corners of this triangle are on one line"},
    {"v 0 0 0\nv 4 0 0\nv 0 4 0\nv 1 1 -1\nv 1 1 1\nv 9 9 9\nf 1 2 3\n"
     "f 4 5 6\n",
     -1, "edge 3 4 passes through triangle 0 1 2 (numbered from 0); move them"},
};

START_TEST(the_place_of_a_defect_is_named)
{
    tf_mesh_file file = good_mesh(meshes[_i].text);
    tf_mesh mesh = tf_mesh_file_elements(&file, 3);
    tf_adaptive_surface *surface;
    tf_error error;
    tf_adaptive_create(&mesh, file.position.item, &surface, &error);
    ck_assert(!tf_error_fault(&file, &error));
    ck_assert_int_eq(file.fault->place, meshes[_i].place);
    ck_assert_ptr_nonnull(strstr(file.fault->text, meshes[_i].words));
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(other_statuses_have_their_message)
{
    tf_mesh_file file = empty_mesh("mesh");
    ck_assert(!tf_status_fault(&file, TF_OUT_OF_MEMORY));
    ck_assert_str_eq(file.fault->text, tf_status_message(TF_OUT_OF_MEMORY));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("scenes/flaws");
    TCase *paired = tcase_create("pairs");
    tcase_add_loop_test(paired, the_pair_is_named, 0,
                        sizeof pairs / sizeof *pairs);
    suite_add_tcase(suite, paired);

    TCase *defects = tcase_create("defects");
    tcase_add_loop_test(defects, the_place_of_a_defect_is_named, 0,
                        sizeof meshes / sizeof *meshes);
    tcase_add_test(defects, other_statuses_have_their_message);
    suite_add_tcase(suite, defects);
    return suite;
}
