// The points of crossing curves.
#include "untangle/curves.h"

#include "support/support.h"
#include "support/tangles.h"

#include <math.h>

static made_tangle own;
static tf_curves curves;

static void find(void)
{
    curves = (tf_curves){.count = 0};
    ck_assert(tf_curves_find(&curves, &own.tangle, own.x));
}

static void release(void)
{
    tf_curves_free(&curves);
    tangle_free(&own);
}

START_TEST(an_edge_through_a_triangle_is_a_point)
{
    tangle_begin(&own, 3);
    tangle_add(&own, 6,
               (double[]){0, 0, 0, 4, 0, 0, 0, 4, 0, //
                          1, 1, -1, 1, 1, 3, 9, 9, 3});
    tangle_add_triangle(&own, 0, 1, 2);
    tangle_add_triangle(&own, 3, 4, 5);
    tangle_finish(&own);
    find();
    ck_assert_uint_eq(curves.count, 2);
    const tf_curve_point *point = curves.point;
    while (point->edge != tf_edge_of(&own.tangle.near, 3, 4))
        point++;
    ck_assert_int_eq(point->facet, tf_triangle_of(&own.tangle.near, 0, 1, 2));
    ck_assert_double_eq(point->at, 0.25);
    ck_assert_double_eq(fabs(point->rise), 4);
    ck_assert_double_eq(point->place.x[0], 1);
    ck_assert_double_eq(point->place.x[2], 0);
    // The first vertex is below the facet just if the rise is positive.
    ck_assert(point->rise * point->normal.x[2] > 0);
    release();
}
END_TEST

START_TEST(what_only_touches_has_no_point)
{
    tangle_begin(&own, 3);
    tangle_add(&own, 6,
               (double[]){0, 0, 0, 4, 0, 0, 0, 4, 0, //
                          1, 1, 0, 1, 1, 3, 9, 9, 3});
    tangle_add_triangle(&own, 0, 1, 2);
    tangle_add_triangle(&own, 3, 4, 5);
    tangle_finish(&own);
    ck_assert_uint_gt(own.tangle.crossings.count, 0);
    find();
    ck_assert_uint_eq(curves.count, 0);
    release();
}
END_TEST

START_TEST(two_edges_in_the_plane_pass_through_each_other)
{
    tangle_begin(&own, 2);
    tangle_add(&own, 4, (double[]){0, 0, 4, 0, 1, -1, 1, 3});
    tangle_add_edge(&own, 0, 1);
    tangle_add_edge(&own, 2, 3);
    tangle_finish(&own);
    find();
    ck_assert_uint_eq(curves.count, 2);
    for (int i = 0; i < 2; i++) {
        const tf_curve_point *point = &curves.point[i];
        ck_assert_int_eq(point->facet, 1 - point->edge);
        ck_assert_double_eq(point->at, 0.25);
        ck_assert_double_eq(point->place.x[0], 1);
        ck_assert_double_eq(point->place.x[1], 0);
    }
    release();
}
END_TEST

// Of points of a sheet through another one, each lies on its edge and, but for
// rounding, on its facet.
START_TEST(points_lie_where_they_should)
{
    tangle_make_bump(&own, 3);
    tangle_finish(&own);
    find();
    ck_assert_uint_gt(curves.count, 10);
    ck_assert_uint_eq(curves.count, own.tangle.crossings.count);
    const tf_neighbors *near = &own.tangle.near;
    for (size_t i = 0; i < curves.count; i++) {
        const tf_curve_point *point = &curves.point[i];
        tf_vector corner = tf_place(near, own.x, near->facet[3 * point->facet]);
        double off = tf_vector_dot(tf_vector_difference(point->place, corner),
                                   point->normal);
        ck_assert_double_le(fabs(off), 1e-14);
        ck_assert_double_ge(point->at, 0);
        ck_assert_double_le(point->at, 1);
    }
    release();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("untangle/curves");
    TCase *tcase = tcase_create("curves");
    tcase_add_test(tcase, an_edge_through_a_triangle_is_a_point);
    tcase_add_test(tcase, what_only_touches_has_no_point);
    tcase_add_test(tcase, two_edges_in_the_plane_pass_through_each_other);
    tcase_add_test(tcase, points_lie_where_they_should);
    suite_add_tcase(suite, tcase);
    return suite;
}
