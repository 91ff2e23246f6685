#include "intersect/velocity.h"

#include "support/queries.h"
#include "support/support.h"

#include <float.h>
#include <math.h>

static tf_vector velocity_of(const query *q, int i, int j)
{
    tf_simplex s[TF_VERTICES], r[TF_VERTICES];
    tf_sweep(q->vertices, q->vertex, s);
    tf_sweep(q->others, query_const_others(q), r);
    return tf_relative_velocity(q->axes, &s[i], &r[j]);
}

START_TEST(the_velocity_is_the_difference_of_the_pivots_displacements)
{
    generator random = generator_new((uint64_t)_i);
    for (long c = 0; c < cases(2000); c++) {
        query q = query_lattice(&random, (query_kind)_i, 100);
        int i = below(&random, q.vertices), j = below(&random, q.others);
        tf_vector v = velocity_of(&q, i, j);

        // Of a sweep the last vertex is the first pivot.
        const tf_worldline *a = &q.vertex[q.vertices - 1 - i];
        const tf_worldline *b = &query_others(&q)[q.others - 1 - j];
        for (int k = 0; k < TF_AXES; k++) {
            double expected = k < q.axes ? a->at[1].x[k] - a->at[0].x[k] -
                                               b->at[1].x[k] + b->at[0].x[k]
                                         : 0;
            ck_assert_msg(v.x[k] == expected, "axis %d: %a, not %a\n%s", k,
                          v.x[k], expected, query_text(&q));
        }
    }
}
END_TEST

/// The velocity on one axis of a point from a to b relative to a vertex from c
/// to d.
static double velocity_along(double a, double b, double c, double d)
{
    query q = query_new(POINT_EDGE);
    q.vertex[0].at[0].x[0] = a;
    q.vertex[0].at[1].x[0] = b;
    q.vertex[2].at[0].x[0] = c;
    q.vertex[2].at[1].x[0] = d;
    return velocity_of(&q, 0, 0).x[0];
}

START_TEST(a_velocity_saturates_only_where_it_overflows)
{
    ck_assert_double_eq(velocity_along(-DBL_MAX, DBL_MAX, 0, 0), DBL_MAX);
    ck_assert_double_eq(velocity_along(DBL_MAX, -DBL_MAX, 0, 0), -DBL_MAX);
    ck_assert_double_eq(velocity_along(0, 0, -DBL_MAX, DBL_MAX), -DBL_MAX);
    ck_assert_double_eq(velocity_along(0, DBL_MAX, 0, -DBL_MAX), DBL_MAX);

    // Both displacements overflow, but not their difference.
    ck_assert_double_eq(
        velocity_along(-0x1p1023, 0x1p1023, -0x1p1023, 0x1p1022), 0x1p1022);
    ck_assert_double_eq(velocity_along(-DBL_MAX, DBL_MAX, -DBL_MAX, DBL_MAX),
                        0);
    ck_assert_double_eq(velocity_along(0, DBL_TRUE_MIN, 0, 0), DBL_TRUE_MIN);
}
END_TEST

START_TEST(a_normal_velocity_is_a_dot_product)
{
    tf_vector velocity = {{1, -2, 3}}, normal = {{0.5, 0.25, -1}};
    ck_assert_double_eq(tf_normal_velocity(velocity, normal), -3);
    ck_assert_double_eq(tf_normal_velocity(velocity, (tf_vector){{0}}), 0);
}
END_TEST

START_TEST(a_normal_velocity_saturates_only_where_it_overflows)
{
    tf_vector normal = {{0.6, 0.8, 0}};
    tf_vector away = {{DBL_MAX, DBL_MAX, 0}};
    tf_vector toward = {{-DBL_MAX, -DBL_MAX, 0}};
    ck_assert_double_eq(tf_normal_velocity(away, normal), DBL_MAX);
    ck_assert_double_eq(tf_normal_velocity(toward, normal), -DBL_MAX);

    // The first two terms overflow, the third brings the sum back.
    normal = (tf_vector){{0.6, 0.6, 0.5}};
    tf_vector turning = {{DBL_MAX, DBL_MAX, -DBL_MAX}};
    double found = tf_normal_velocity(turning, normal);
    ck_assert_msg(fabs(found / DBL_MAX - 0.7) < 1e-15, "%a", found);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("intersect/velocity");
    TCase *tcase = tcase_create("velocity");
    tcase_add_loop_test(
        tcase, the_velocity_is_the_difference_of_the_pivots_displacements, 0,
        KINDS);
    tcase_add_test(tcase, a_velocity_saturates_only_where_it_overflows);
    tcase_add_test(tcase, a_normal_velocity_is_a_dot_product);
    tcase_add_test(tcase, a_normal_velocity_saturates_only_where_it_overflows);
    suite_add_tcase(suite, tcase);
    return suite;
}
