// Long edges are split.
#include "remesh/remesher.h"

#include "support/adaptive_surfaces.h"
#include "support/remeshers.h"
#include "support/support.h"

START_TEST(long_edges_are_split_the_longest_first)
{
    tf_remesher *remesher = remesher_begin(adaptive_sheet(1, 1), 0.76);
    ck_assert_int_eq(tf_split_pass(remesher), TF_OK);
    ck_assert_int_eq(done(remesher, TF_SPLIT), 1); // the diagonal
    ck_assert_double_eq(place_of(remesher->surface, 4)[0], 0.5);
    ck_assert_double_eq(longest_edge(remesher->surface), 1);
    remesher_end(remesher);

    remesher = remesher_begin(adaptive_sheet(1, 1), 0.74);
    ck_assert_int_eq(tf_split_pass(remesher), TF_OK);
    ck_assert_int_eq(done(remesher, TF_SPLIT), 5);
    ck_assert_int_eq(triangles_of(remesher->surface), 8);
    remesher_end(remesher);
}
END_TEST

// The edge over the roof is no crease: its middle goes to the nearest point of
// the original, where it is.
START_TEST(middles_stay_on_the_original)
{
    static double place[][3] = {
        {0, 0, 0}, {2, 0, 0.25}, {2, 2, 0}, {0, 2, 0.25}};
    static const int triangle[] = {0, 1, 2, 0, 2, 3};
    tf_remesher *remesher =
        remesher_begin(adaptive_of(4, place, 2, triangle), 1);
    ck_assert_int_eq(tf_split_pass(remesher), TF_OK);
    ck_assert_double_eq(place_of(remesher->surface, 4)[2], 0);
    tf_original now = {0};
    ck_assert_int_eq(tf_adaptive_compact(remesher->surface, NULL), TF_OK);
    ck_assert(tf_original_copy(&now, remesher->surface));
    ck_assert_double_eq_tol(tf_original_farthest(&remesher->original, &now), 0,
                            1e-15);
    tf_original_free(&now);
    remesher_end(remesher);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("remesh/split_pass");
    TCase *tcase = tcase_create("splits");
    tcase_add_test(tcase, long_edges_are_split_the_longest_first);
    tcase_add_test(tcase, middles_stay_on_the_original);
    suite_add_tcase(suite, tcase);
    return suite;
}
