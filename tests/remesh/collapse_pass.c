// Short edges collapse.
#include "remesh/remesher.h"

#include "support/adaptive_surfaces.h"
#include "support/remeshers.h"
#include "support/support.h"

START_TEST(short_edges_collapse_and_corners_stay)
{
    tf_remesher *remesher = remesher_begin(adaptive_sheet(6, 6), 3);
    ck_assert_int_eq(tf_collapse_pass(remesher), TF_OK);
    ck_assert_int_gt(done(remesher, TF_COLLAPSE), 10);
    ck_assert_double_le(longest_edge(remesher->surface), 4);
    static const int corner[] = {0, 6, 42, 48};
    for (int i = 0; i < 4; i++) {
        ck_assert_double_eq(place_of(remesher->surface, corner[i])[0],
                            i % 2 * 6);
        ck_assert_double_eq(place_of(remesher->surface, corner[i])[1],
                            i / 2 * 6);
    }
    // The sheet is still flat, and as large as before.
    tf_original now = {0};
    ck_assert_int_eq(tf_adaptive_compact(remesher->surface, NULL), TF_OK);
    ck_assert(tf_original_copy(&now, remesher->surface));
    ck_assert_double_eq_tol(tf_original_farthest(&remesher->original, &now), 0,
                            1e-15);
    ck_assert_double_eq_tol(tf_original_farthest(&now, &remesher->original), 0,
                            1e-15);
    tf_original_free(&now);
    remesher_end(remesher);
}
END_TEST

START_TEST(edges_that_are_long_enough_stay)
{
    tf_remesher *remesher = remesher_begin(adaptive_sheet(4, 4), 1.2);
    ck_assert_int_eq(tf_collapse_pass(remesher), TF_OK);
    ck_assert_int_eq(done(remesher, TF_COLLAPSE), 0);
    ck_assert_int_eq(triangles_of(remesher->surface), 32);
    remesher_end(remesher);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("remesh/collapse_pass");
    TCase *tcase = tcase_create("collapses");
    tcase_add_test(tcase, short_edges_collapse_and_corners_stay);
    tcase_add_test(tcase, edges_that_are_long_enough_stay);
    suite_add_tcase(suite, tcase);
    return suite;
}
