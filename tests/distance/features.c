// Features of elements: which of them hold the nearest points.
#include "distance/features.h"

#include "support/support.h"

#include <math.h>

/// Which of the features of a pair hold their own nearest points, a bit each.
static unsigned features_inside(tf_kind kind, const double at[])
{
    const double *x[] = {at, at + 3, at + 6, at + 9};
    const tf_features *features;
    int count = tf_features_of(kind, &features);
    tf_exact_vertices exact;
    tf_exact_vertices_set(kind, x, 0, &exact);
    unsigned inside = 0;
    for (int i = 0; i < count; i++) {
        tf_feature_distance found;
        if (tf_feature_distance_find(&exact, &features[i], &found))
            inside |= 1u << i;
    }
    return inside;
}

START_TEST(a_point_over_a_triangle_is_over_its_edges)
{
    static const double over[] = {1, 1, 7, 0, 0, 0, 4, 0, 0, 0, 4, 0},
                        beyond[] = {9, 9, 7, 0, 0, 0, 4, 0, 0, 0, 4, 0},
                        flat[] = {1, 1, 7, 0, 0, 0, 4, 0, 0, 2, 0, 0};
    ck_assert_uint_eq(features_inside(TF_POINT_TRIANGLE, over), 0x7f);
    ck_assert_uint_eq(features_inside(TF_POINT_TRIANGLE, beyond), 0x74);
    // Without area it has three edges, one of them within another.
    ck_assert_uint_eq(features_inside(TF_POINT_TRIANGLE, flat), 0x7a);
}
END_TEST

START_TEST(edges_that_cross_hold_points_of_both)
{
    static const double cross[] = {-1, 0, 0, 1, 0, 0, 0, -1, 1, 0, 1, 1},
                        parallel[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    ck_assert_uint_eq(features_inside(TF_EDGE_EDGE, cross), 0x1ff);
    ck_assert_uint_eq(features_inside(TF_EDGE_EDGE, parallel), 0x1e0);
}
END_TEST

START_TEST(a_coordinate_that_is_not_needed_is_zero)
{
    static const double at[] = {0, 0, 1, -1, 1, 1};
    const double *x[] = {at, at + 2, at + 4};
    tf_exact_vertices exact;
    const tf_features *features;
    tf_feature_distance found;
    tf_exact_vertices_set(TF_POINT_EDGE, x, 0, &exact);
    ck_assert_int_eq(tf_features_of(TF_POINT_EDGE, &features), 3);
    ck_assert(tf_feature_distance_find(&exact, &features[0], &found));
    int exponent;
    double square = tf_wide_round(&found.square, &exponent);
    ck_assert(ldexp(square, exponent) == 4);
    ck_assert(found.weight[1] == 0.5 && found.weight[2] == 0.5);
}
END_TEST

// A contact pushes none of the vertices whose weights are zero.
START_TEST(only_vertices_of_a_feature_have_weights)
{
    static const double at[] = {1, 1, 7, 0, 0, 0, 4, 0, 0, 0, 4, 0};
    const double *x[] = {at, at + 3, at + 6, at + 9};
    static const tf_kind kinds[] = {TF_POINT_TRIANGLE, TF_EDGE_EDGE};
    for (int k = 0; k < 2; k++) {
        tf_exact_vertices exact;
        const tf_features *features;
        tf_exact_vertices_set(kinds[k], x, 0, &exact);
        for (int i = tf_features_of(kinds[k], &features) - 1; i >= 0; i--) {
            tf_feature_distance found;
            double others = 0;
            if (features[i].kind != TF_TWO_VERTICES ||
                !tf_feature_distance_find(&exact, &features[i], &found))
                continue;
            for (int v = 0; v < 4; v++)
                if (v != features[i].place[0] && v != features[i].place[1])
                    others += fabs(found.weight[v]);
            ck_assert(others == 0);
        }
    }
}
END_TEST

START_TEST(vertices_at_the_origin_have_the_unit_one)
{
    static const double at[9] = {0};
    const double *x[] = {at, at + 2, at + 4};
    tf_exact_vertices exact;
    tf_exact_vertices_set(TF_POINT_EDGE, x, 0, &exact);
    ck_assert_int_eq(exact.unit, 0);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("distance/features");
    TCase *tcase = tcase_create("features");
    tcase_add_test(tcase, a_point_over_a_triangle_is_over_its_edges);
    tcase_add_test(tcase, edges_that_cross_hold_points_of_both);
    tcase_add_test(tcase, a_coordinate_that_is_not_needed_is_zero);
    tcase_add_test(tcase, only_vertices_of_a_feature_have_weights);
    tcase_add_test(tcase, vertices_at_the_origin_have_the_unit_one);
    suite_add_tcase(suite, tcase);
    return suite;
}
