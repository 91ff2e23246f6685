// Passes, by the policy that keeps the shape.
#include "remesh/passes.h"

#include "remesh/keep_shape.h"
#include "remesh/reach.h"
#include "support/adaptive_surfaces.h"
#include "support/remeshers.h"
#include "support/support.h"
#include "surgery/star.h"

#include <math.h>

static tf_remesher *begin(tf_adaptive_surface *surface, double edge)
{
    return remesher_begin(surface, &tf_keep_shape, edge);
}

static void make_pass(tf_remesher *remesher, tf_operation operation)
{
    ck_assert_int_eq(tf_remesh_pass(remesher, operation), TF_OK);
}

/// Expects that the surface lies on its original, and in the opposite direction
/// if it is to be as large; closes its gaps.
static void expect_on_original(tf_remesher *remesher, bool as_large)
{
    tf_original now = {0};
    ck_assert_int_eq(tf_adaptive_compact(remesher->surface, NULL), TF_OK);
    ck_assert_int_eq(tf_original_begin(&now, remesher->surface, NULL), TF_OK);
    ck_assert_double_lt(
        tf_surface_reach(&remesher->original, remesher->surface, 0, NULL, NULL)
            .most,
        1e-14);
    if (as_large)
        ck_assert_double_lt(
            tf_surface_reach(&now, remesher->original.surface, 0, NULL, NULL)
                .most,
            1e-14);
    tf_original_free(&now);
}

// Splits ----------------------------------------------------------------------

START_TEST(long_edges_are_split_the_longest_first)
{
    tf_remesher *remesher = begin(adaptive_sheet(1, 1), 0.76);
    make_pass(remesher, TF_SPLIT);
    ck_assert_int_eq(done(remesher, TF_SPLIT), 1); // the diagonal
    ck_assert_double_eq(coordinates_of(remesher->surface, 4)[0], 0.5);
    ck_assert_double_eq(longest_edge(remesher->surface), 1);
    remesher_end(remesher);

    remesher = begin(adaptive_sheet(1, 1), 0.74);
    make_pass(remesher, TF_SPLIT);
    ck_assert_int_eq(done(remesher, TF_SPLIT), 5);
    ck_assert_int_eq(triangles_of(remesher->surface), 8);
    remesher_end(remesher);
}
END_TEST

// The edge over the roof is not sharp: its middle goes to the nearest point of
// the original, where it is.
START_TEST(middles_stay_on_the_original)
{
    static double position[][3] = {
        {0, 0, 0}, {2, 0, 0.25}, {2, 2, 0}, {0, 2, 0.25}};
    static const int triangle[] = {0, 1, 2, 0, 2, 3};
    tf_remesher *remesher = begin(adaptive_of(4, position, 2, triangle), 1);
    make_pass(remesher, TF_SPLIT);
    ck_assert_double_eq(coordinates_of(remesher->surface, 4)[2], 0);
    expect_on_original(remesher, false);
    remesher_end(remesher);
}
END_TEST

// Collapses -------------------------------------------------------------------

START_TEST(short_edges_collapse_and_corners_stay)
{
    tf_remesher *remesher = begin(adaptive_sheet(6, 6), 3);
    make_pass(remesher, TF_COLLAPSE);
    ck_assert_int_gt(done(remesher, TF_COLLAPSE), 10);
    ck_assert_double_le(longest_edge(remesher->surface), 4);
    static const int corner[] = {0, 6, 42, 48};
    for (int i = 0; i < 4; i++) {
        const double *x = coordinates_of(remesher->surface, corner[i]);
        ck_assert_double_eq(x[0], i % 2 * 6);
        ck_assert_double_eq(x[1], i / 2 * 6);
    }
    expect_on_original(remesher, true);
    remesher_end(remesher);
}
END_TEST

START_TEST(edges_that_are_long_enough_stay)
{
    tf_remesher *remesher = begin(adaptive_sheet(4, 4), 1.2);
    make_pass(remesher, TF_COLLAPSE);
    ck_assert_int_eq(done(remesher, TF_COLLAPSE), 0);
    ck_assert_int_eq(triangles_of(remesher->surface), 32);
    remesher_end(remesher);
}
END_TEST

// Flips -----------------------------------------------------------------------

static tf_remesher *kite(double height)
{
    static double position[4][3];
    static const double flat[4][3] = {
        {-3, 0, 0}, {0, -1, 0}, {3, 0, 0}, {0, 1, 0}};
    static const int triangle[] = {0, 1, 2, 0, 2, 3};
    for (int i = 0; i < 12; i++)
        position[i / 3][i % 3] =
            flat[i / 3][i % 3] + (i % 3 == 2 && i % 2 ? height : 0);
    return begin(adaptive_of(4, position, 2, triangle), 1);
}

START_TEST(edges_flip_to_better_triangles_once)
{
    tf_remesher *remesher = kite(0);
    make_pass(remesher, TF_FLIP);
    ck_assert_int_eq(done(remesher, TF_FLIP), 1);
    ck_assert(has_triangle(remesher->surface, 0, 1, 3));
    make_pass(remesher, TF_FLIP);
    ck_assert_int_eq(done(remesher, TF_FLIP), 1);
    remesher_end(remesher);
}
END_TEST

START_TEST(edges_that_are_bent_do_not_flip)
{
    for (int i = 1; i < 3; i++) { // a little, and sharply
        tf_remesher *remesher = kite(i);
        make_pass(remesher, TF_FLIP);
        ck_assert_int_eq(done(remesher, TF_FLIP) + refused(remesher, TF_FLIP),
                         0);
        remesher_end(remesher);
    }
}
END_TEST

START_TEST(diagonals_of_squares_do_not_flip)
{
    tf_remesher *remesher = begin(adaptive_sheet(3, 3), 1);
    make_pass(remesher, TF_FLIP);
    ck_assert_int_eq(done(remesher, TF_FLIP), 0);
    remesher_end(remesher);
}
END_TEST

// Moves -----------------------------------------------------------------------

START_TEST(vertices_go_to_the_middles_of_their_stars)
{
    static const double off[] = {1.3, 0.8, 0};
    tf_remesher *remesher = begin(adaptive_sheet(2, 2), 1);
    tf_vertex_put(remesher->surface, 4, off);
    for (int i = 0; i < 20; i++)
        make_pass(remesher, TF_SMOOTH);
    const double *x = coordinates_of(remesher->surface, 4);
    ck_assert_double_lt(hypot(x[0] - 1, x[1] - 1), 0.2);
    ck_assert_double_eq(x[2], 0);
    ck_assert_int_gt(done(remesher, TF_SMOOTH), 0);
    // Small moves are not worth it.
    ck_assert_int_lt(done(remesher, TF_SMOOTH), 10);
    for (int v = 0; v < 9; v++)
        if (v != 4)
            ck_assert_double_eq(coordinates_of(remesher->surface, v)[0], v % 3);
    remesher_end(remesher);
}
END_TEST

START_TEST(vertices_slide_along_the_boundary)
{
    static const double off[] = {1.5, 0, 0};
    tf_adaptive_surface *sheet = adaptive_sheet(2, 2);
    tf_vertex_put(sheet, 1, off);
    tf_remesher *remesher = begin(sheet, 1);
    ck_assert(tf_trace_begin(&remesher->trace, &remesher->original,
                             &remesher->sharp_before));
    make_pass(remesher, TF_SMOOTH);
    ck_assert_double_eq(coordinates_of(sheet, 1)[0], 1);
    ck_assert_double_eq(coordinates_of(sheet, 1)[1], 0);
    ck_assert_double_eq(tf_find_sharp_edge(&remesher->sharp, 1, 2)->length, 1);
    // It comes from the edge, at two thirds from its start.
    const tf_origin *origin =
        (const tf_origin *)remesher->trace.origin.data + 1;
    const int *corner =
        tf_triangle(remesher->original.surface, origin->triangle);
    for (int i = 0; i < 3; i++) {
        double weight = corner[i] < 2 ? (1 + corner[i]) / 3.0 : 0;
        ck_assert_double_eq_tol(origin->barycentric[i], weight, 1e-15);
    }
    remesher_end(remesher);
}
END_TEST

// Rounds ----------------------------------------------------------------------

/// How many splits so many passes make.
static int splits_of(int passes)
{
    tf_remesher *remesher = begin(adaptive_tetrahedron(), 0.3);
    for (int i = 0; i < passes; i++)
        make_pass(remesher, TF_SPLIT);
    int splits = done(remesher, TF_SPLIT);
    remesher_end(remesher);
    return splits;
}

START_TEST(a_round_repeats_a_pass_until_it_does_nothing_or_often_enough)
{
    for (int most = 0; most < 12; most++) {
        tf_remesh_policy policy = {.longest = {4, 3},
                                   .shortest = {4, 5},
                                   .pass = {{TF_SPLIT, most}},
                                   .choose_split = tf_keep_shape.choose_split};
        tf_remesher *remesher =
            remesher_begin(adaptive_tetrahedron(), &policy, 0.3);
        ck_assert_int_eq(tf_remesh_round(remesher), TF_OK);
        int splits = done(remesher, TF_SPLIT);
        remesher_end(remesher);
        ck_assert_int_eq(splits, splits_of(most));
    }
    ck_assert_int_lt(splits_of(1), splits_of(4));
    ck_assert_int_eq(splits_of(11), splits_of(10));
}
END_TEST

static bool choose_nothing(tf_remesher *remesher, int corner,
                           tf_edge_collapse *collapse)
{
    (void)remesher, (void)corner, (void)collapse;
    return false;
}

START_TEST(what_a_policy_does_not_choose_is_not_tried)
{
    tf_remesh_policy policy = tf_keep_shape;
    policy.choose_collapse = choose_nothing;
    tf_remesher *remesher = remesher_begin(adaptive_sheet(6, 6), &policy, 3);
    ck_assert_int_eq(tf_remesh_round(remesher), TF_OK);
    ck_assert_int_eq(
        done(remesher, TF_COLLAPSE) + refused(remesher, TF_COLLAPSE), 0);
    remesher_end(remesher);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("remesh/passes");
    TCase *tcase = tcase_create("passes");
    tcase_add_test(tcase, long_edges_are_split_the_longest_first);
    tcase_add_test(tcase, middles_stay_on_the_original);
    tcase_add_test(tcase, short_edges_collapse_and_corners_stay);
    tcase_add_test(tcase, edges_that_are_long_enough_stay);
    tcase_add_test(tcase, edges_flip_to_better_triangles_once);
    tcase_add_test(tcase, edges_that_are_bent_do_not_flip);
    tcase_add_test(tcase, diagonals_of_squares_do_not_flip);
    tcase_add_test(tcase, vertices_go_to_the_middles_of_their_stars);
    tcase_add_test(tcase, vertices_slide_along_the_boundary);
    tcase_add_test(
        tcase, a_round_repeats_a_pass_until_it_does_nothing_or_often_enough);
    tcase_add_test(tcase, what_a_policy_does_not_choose_is_not_tried);
    suite_add_tcase(suite, tcase);
    return suite;
}
