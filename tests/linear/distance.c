#include "linear/distance.h"

#include "support/support.h"

#include <math.h>

static tf_vector between(const tf_vector x[], int from, int to,
                         const double weight[])
{
    tf_vector p = {{0}};
    for (int i = from; i < to; i++)
        for (int k = 0; k < TF_AXES; k++)
            p.x[k] += weight[i] * x[i].x[k];
    return p;
}

/// Expect weights of points at the distance, and return that.
static double distance(int vertices, int others, const tf_vector x[])
{
    tf_point_pair found = tf_nearest_points(vertices, others, x);
    double sum[2] = {0};
    for (int i = 0; i < vertices + others; i++) {
        ck_assert_double_ge(found.weight[i], 0);
        sum[i >= vertices] += found.weight[i];
    }
    ck_assert_double_eq_tol(sum[0], 1, 1e-14);
    ck_assert_double_eq_tol(sum[1], 1, 1e-14);
    tf_vector gap = tf_vector_difference(
        between(x, 0, vertices, found.weight),
        between(x, vertices, vertices + others, found.weight));
    ck_assert_double_eq_tol(sqrt(tf_vector_dot(gap, gap)), found.distance,
                            1e-13);
    return found.distance;
}

// Closed forms ----------------------------------------------------------------

START_TEST(a_point_and_a_segment_have_the_expected_distance)
{
    tf_vector x[] = {{{1, 2, 0}}, {{0, 0, 0}}, {{4, 0, 0}}};
    ck_assert_double_eq(distance(1, 2, x), 2);
    x[0] = (tf_vector){{7, 4, 0}};
    ck_assert_double_eq(distance(1, 2, x), 5);
    x[2] = x[1];
    ck_assert_double_eq_tol(distance(1, 2, x), sqrt(65), 1e-15);
}
END_TEST

START_TEST(a_point_and_a_triangle_have_the_expected_distance)
{
    tf_vector x[] = {{{1, 1, 3}}, {{0, 0, 0}}, {{4, 0, 0}}, {{0, 4, 0}}};
    ck_assert_double_eq(distance(1, 3, x), 3);
    x[0] = (tf_vector){{2, -3, 4}};
    ck_assert_double_eq(distance(1, 3, x), 5);
    x[0] = (tf_vector){{-3, 8, 0}};
    ck_assert_double_eq(distance(1, 3, x), 5);
    x[0] = (tf_vector){{3, 3, 1}};
    ck_assert_double_eq_tol(distance(1, 3, x), sqrt(3), 1e-15);
    x[3] = (tf_vector){{2, 0, 0}};
    ck_assert_double_eq_tol(distance(1, 3, x), sqrt(10), 1e-15);
}
END_TEST

START_TEST(two_segments_have_the_expected_distance)
{
    tf_vector x[] = {{{-1, 0, 0}}, {{1, 0, 0}}, {{0, -1, 2}}, {{0, 1, 2}}};
    ck_assert_double_eq(distance(2, 2, x), 2);
    x[2].x[1] = 3;
    ck_assert_double_eq_tol(distance(2, 2, x), sqrt(5), 1e-15);
    x[2] = (tf_vector){{0, 0, 3}}; // parallel
    x[3] = (tf_vector){{9, 0, 3}};
    ck_assert_double_eq(distance(2, 2, x), 3);
    x[1] = x[0]; // a point
    ck_assert_double_eq_tol(distance(2, 2, x), sqrt(10), 1e-15);
}
END_TEST

START_TEST(two_triangles_have_the_expected_distance)
{
    tf_vector x[] = {{{0, 0, 0}}, {{4, 0, 0}}, {{0, 4, 0}},
                     {{1, 1, 2}}, {{2, 1, 5}}, {{1, 2, 5}}};
    ck_assert_double_eq(distance(3, 3, x), 2);
    x[3].x[2] = -1; // an edge goes through the other triangle
    ck_assert_double_eq(distance(3, 3, x), 0);
    for (int i = 3; i < 6; i++)
        x[i].x[0] += 5; // now beside it
    ck_assert_double_gt(distance(3, 3, x), 1);
}
END_TEST

// Random elements -------------------------------------------------------------

static void fill(generator *random, int count, tf_vector x[])
{
    for (int i = 0; i < count; i++)
        for (int k = 0; k < TF_AXES; k++)
            x[i].x[k] =
                below(random, 2) ? uniform(random, -1, 1) : below(random, 3);
}

static void random_weights(generator *random, int from, int to, double weight[])
{
    double sum = 0;
    for (int i = from; i < to; i++)
        sum += weight[i] = uniform(random, 1e-9, 1);
    for (int i = from; i < to; i++)
        weight[i] /= sum;
}

static const struct shape {
    int vertices, others;
} shapes[] = {{1, 2}, {1, 3}, {2, 2}, {3, 3}};

START_TEST(no_points_are_nearer)
{
    generator random = generator_new((uint64_t)_i);
    struct shape shape = shapes[_i];
    int count = shape.vertices + shape.others;
    for (long n = 0; n < cases(2000); n++) {
        tf_vector x[TF_MOST_CORNERS];
        double weight[TF_MOST_CORNERS];
        fill(&random, count, x);
        double least = distance(shape.vertices, shape.others, x);
        for (int i = 0; i < 30; i++) {
            random_weights(&random, 0, shape.vertices, weight);
            random_weights(&random, shape.vertices, count, weight);
            tf_vector gap =
                tf_vector_difference(between(x, 0, shape.vertices, weight),
                                     between(x, shape.vertices, count, weight));
            ck_assert_double_le(least, sqrt(tf_vector_dot(gap, gap)) + 1e-13);
        }
    }
}
END_TEST

START_TEST(the_order_of_elements_does_not_change_the_distance)
{
    generator random = generator_new(9);
    for (long n = 0; n < cases(2000); n++) {
        tf_vector x[TF_MOST_CORNERS], swapped[TF_MOST_CORNERS];
        fill(&random, 6, x);
        for (int i = 0; i < 6; i++)
            swapped[i] = x[(i + 3) % 6];
        ck_assert_double_eq_tol(distance(3, 3, x), distance(3, 3, swapped),
                                1e-13);
    }
}
END_TEST

START_TEST(products_that_overflow_make_the_distance_infinite)
{
    tf_vector x[] = {{{-1e300, 0, 0}}, {{1e300, 1, 0}}, {{1e300, 1e300, 0}}};
    double far = tf_nearest_points(1, 2, x).distance;
    ck_assert(isinf(far) && far > 0);
}
END_TEST

START_TEST(elements_without_size_do_not_cross)
{
    double weight[4];
    tf_vector x[4] = {{{1, 2, 3}}, {{0, 0, 0}}, {{1, 1, 1}}, {{2, 2, 2}}};
    ck_assert(!tf_crossing_weights(1, 3, x, weight));
    x[0] = x[3];
    ck_assert(!tf_crossing_weights(2, 2, (tf_vector[]){x[1], x[2], x[2], x[3]},
                                   weight));
    ck_assert(
        !tf_crossing_weights(1, 2, (tf_vector[]){x[0], x[1], x[1]}, weight));
}
END_TEST

START_TEST(coordinates_reach_a_bound_that_they_equal)
{
    static const double weight[] = {1, 0, -0.25};
    ck_assert(tf_weights_reach(2, weight, 0));
    ck_assert(tf_weights_reach(3, weight, -0.25));
    ck_assert(!tf_weights_reach(3, weight, 0));
    ck_assert(!tf_weights_reach(1, (double[]){NAN}, -1));
}
END_TEST

// The square is that of the nearest points' distance, for triangles of all
// shapes, from fat ones to those without area.
START_TEST(the_squared_distance_is_that_of_the_nearest_point)
{
    generator random = generator_new((uint64_t)_i);
    double thin = ldexp(1, -6 * _i);
    for (long i = 0; i < cases(20000); i++) {
        tf_vector x[4];
        for (int k = 0; k < 12; k++)
            x[k / 3].x[k % 3] = uniform(&random, -1, 1);
        for (int k = 0; k < 3; k++) // toward the first edge
            x[3].x[k] =
                x[1].x[k] + 0.375 * (x[2].x[k] - x[1].x[k]) + thin * x[3].x[k];
        double far = tf_nearest_points(1, 3, x).distance;
        ck_assert_double_eq_tol(sqrt(tf_squared_distance(x)), far, 1e-7);
        if (_i == 0)
            ck_assert_double_eq_tol(tf_squared_distance(x), far * far, 1e-13);
    }
    tf_vector right[] = {{{-3, 8, 0}}, {{0, 0, 0}}, {{4, 0, 0}}, {{0, 4, 0}}};
    ck_assert_double_eq(tf_squared_distance(right), 25);
    right[0] = (tf_vector){{1, 1, 3}};
    ck_assert_double_eq(tf_squared_distance(right), 9);
    right[0] = (tf_vector){{2, -3, 4}};
    ck_assert_double_eq(tf_squared_distance(right), 25);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("linear/distance");
    TCase *c = tcase_create("distances");
    tcase_add_test(c, a_point_and_a_segment_have_the_expected_distance);
    tcase_add_test(c, a_point_and_a_triangle_have_the_expected_distance);
    tcase_add_test(c, two_segments_have_the_expected_distance);
    tcase_add_test(c, two_triangles_have_the_expected_distance);
    tcase_add_loop_test(c, no_points_are_nearer, 0, 4);
    tcase_add_test(c, the_order_of_elements_does_not_change_the_distance);
    tcase_add_test(c, products_that_overflow_make_the_distance_infinite);
    tcase_add_test(c, elements_without_size_do_not_cross);
    tcase_add_test(c, coordinates_reach_a_bound_that_they_equal);
    tcase_add_loop_test(c, the_squared_distance_is_that_of_the_nearest_point, 0,
                        8);
    suite_add_tcase(s, c);
    return s;
}
