// A surface that is being untangled: its sizes, and what crosses.
#include "untangle/tangle.h"

#include "support/support.h"
#include "support/tangles.h"

static made_tangle own;

/// A triangle in the plane z = 0, and an edge of another one through it.
static void make_two_triangles(void)
{
    tangle_begin(&own, 3);
    tangle_add(&own, 6,
               (double[]){0, 0, 0, 4, 0, 0, 0, 4, 0, //
                          1, 1, -1, 1, 1, 1, 9, 9, 1});
    tangle_add_triangle(&own, 0, 1, 2);
    tangle_add_triangle(&own, 3, 4, 5);
    tangle_finish(&own);
}

START_TEST(a_check_finds_what_crosses)
{
    make_two_triangles();
    ck_assert_uint_eq(own.tangle.crossings.count, 2);
    const tf_crossing *first = own.tangle.crossings.crossing;
    ck_assert_int_eq(first->kind, TF_EDGE_THROUGH_TRIANGLE);
    ck_assert_int_eq(tf_crossing_corners(first), 5);
    tangle_free(&own);
}
END_TEST

START_TEST(sizes_are_means)
{
    make_two_triangles();
    ck_assert_double_eq(own.tangle.edge_at[0], 4);
    ck_assert_double_gt(own.tangle.edge, 4);
    tangle_free(&own);
}
END_TEST

START_TEST(what_only_fixed_vertices_cross_is_beyond_help)
{
    make_two_triangles();
    for (int v = 0; v < 5; v++) {
        ck_assert_uint_eq(tf_tangle_beyond(&own.tangle), 0);
        own.fixed[v] = true;
    }
    // The second crossing has vertex 5, which is free.
    ck_assert_uint_eq(tf_tangle_beyond(&own.tangle), 1);
    ck_assert(tf_are_fixed(&own.tangle, 5, (int[]){0, 1, 2, 3, 4}));
    own.fixed[5] = true;
    ck_assert_uint_eq(tf_tangle_beyond(&own.tangle), 2);
    tangle_free(&own);
}
END_TEST

START_TEST(crossings_of_two_edges_have_four_corners)
{
    tangle_begin(&own, 2);
    tangle_add(&own, 4, (double[]){0, 0, 2, 2, 0, 2, 2, 0});
    tangle_add_edge(&own, 0, 1);
    tangle_add_edge(&own, 2, 3);
    tangle_finish(&own);
    ck_assert_uint_eq(own.tangle.crossings.count, 1);
    ck_assert_int_eq(tf_crossing_corners(own.tangle.crossings.crossing), 4);
    tangle_free(&own);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("untangle/tangle");
    TCase *tcase = tcase_create("tangle");
    tcase_add_test(tcase, a_check_finds_what_crosses);
    tcase_add_test(tcase, sizes_are_means);
    tcase_add_test(tcase, what_only_fixed_vertices_cross_is_beyond_help);
    tcase_add_test(tcase, crossings_of_two_edges_have_four_corners);
    suite_add_tcase(suite, tcase);
    return suite;
}
