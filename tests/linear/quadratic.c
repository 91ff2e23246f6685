#include "linear/quadratic.h"

#include "support/linear_methods.h"
#include "support/scenes.h"
#include "support/statuses.h"
#include "support/support.h"

#include <math.h>

START_TEST(a_falling_point_meets_an_edge)
{
    query q = scene_hit(POINT_EDGE);
    tf_contact contact = cubic_answer(&q, 0);
    expect_contact(&q, &contact);
    ck_assert_int_eq(contact.verdict, TF_HIT);
    ck_assert_int_eq(contact.classification, TF_GENERIC);
    ck_assert_double_eq(contact.toi_lo, 0.5);
    ck_assert_double_eq(contact.normal[1], 1);
    ck_assert_double_eq(contact.normal_velocity, -2);
    ck_assert_double_eq_tol(contact.barycentric[1][1], 1.0 / 3, 1e-15);
}
END_TEST

// The plank of the seesaw turns about the origin and, in linear motion, never
// leaves it: at the height h a fly stays clear, and at the origin it does not.

static query seesaw(double height)
{
    query q = query_new(POINT_EDGE);
    const double x[] = {0, height, -2, 2, 2, -2, 0, height, -2, -2, 2, 2};
    for (int i = 0; i < query_size(&q); i++)
        *query_coordinate(&q, i) = x[i];
    return q;
}

START_TEST(a_point_beside_the_center_of_a_turning_edge_is_apart)
{
    query q = seesaw(1);
    ck_assert_int_eq(cubic_answer(&q, 0).verdict, TF_APART);
    q = seesaw(0);
    ck_assert_int_eq(cubic_answer(&q, 0).verdict, TF_HIT);
}
END_TEST

// A point crosses the line of an edge twice: outside, then inside, at the
// second root.

START_TEST(a_root_outside_does_not_hide_one_inside)
{
    // The point moves from (0, 1) to (8, 1), the edge from (4, 0)-(9, 0) to
    // (4, 3)-(9, 0): the height of the line over x = 8t is 3t (9 - 8t) / 5.
    query q = query_new(POINT_EDGE);
    static const double x[] = {0, 1, 4, 0, 9, 0, 8, 1, 4, 3, 9, 0};
    for (int i = 0; i < query_size(&q); i++)
        *query_coordinate(&q, i) = x[i];
    double root = (27 + sqrt(27 * 27 - 4 * 24 * 5)) / 48;
    double first = (27 - sqrt(27 * 27 - 4 * 24 * 5)) / 48;
    ck_assert_double_lt(8 * first, 4); // outside
    tf_contact contact = cubic_answer(&q, 0);
    ck_assert_int_eq(contact.verdict, TF_HIT);
    ck_assert_double_eq_tol(contact.toi_lo, root, 1e-15);
}
END_TEST

START_TEST(motion_within_the_line_is_degenerate)
{
    // The point runs along the line into the edge: the ends of the step show
    // it, unless it also leaves the edge again.
    query q = query_new(POINT_EDGE);
    static const double x[] = {0, 0, 2, 0, 4, 0, 3, 0, 2, 0, 4, 0};
    for (int i = 0; i < query_size(&q); i++)
        *query_coordinate(&q, i) = x[i];
    tf_contact contact = cubic_answer(&q, 0);
    ck_assert_int_eq(contact.classification, TF_DEGENERATE);
    ck_assert_double_eq(contact.toi_lo, 1);
    q.vertex[0].at[1].x[0] = 5;
    ck_assert_int_eq(cubic_answer(&q, 0).verdict, TF_APART);
    double toi = 0;
    ck_assert(linear_query_truth(&q, &toi));
    ck_assert_double_eq_tol(toi, 0.4, 1e-15);
}
END_TEST

START_TEST(random_queries_are_decided_right)
{
    generator random = generator_new(1);
    for (long i = 0; i < cases(20000); i++) {
        query q = i % 2 ? query_soup(&random, POINT_EDGE)
                        : query_lattice(&random, POINT_EDGE, 1 << 20);
        expect_linear_truth(&q);
    }
}
END_TEST

START_TEST(contacts_are_finite_and_in_their_ranges)
{
    generator random = generator_new(2);
    for (long i = 0; i < cases(20000); i++) {
        query q = i % 2 ? query_extreme(&random, POINT_EDGE)
                        : query_lattice(&random, POINT_EDGE, 4);
        tf_contact strict = cubic_answer(&q, 0), loose = cubic_answer(&q, 1e-2);
        expect_contact(&q, &strict);
        expect_contact(&q, &loose);
        ck_assert_msg(strict.verdict == TF_APART || loose.verdict == TF_HIT,
                      "%s", query_text(&q));
    }
}
END_TEST

// Statuses --------------------------------------------------------------------

static tf_status ask_quadratic(const tf_arithmetic *arithmetic,
                               const tf_motion *motion, const int vertex[],
                               tf_contact *contact)
{
    static const tf_tolerances none = {0};
    return tf_quadratic_point_edge(arithmetic ? &none : NULL, motion, vertex[0],
                                   vertex + 1, contact);
}

static void use_quadratic(void)
{
    statuses_use(POINT_EDGE, ask_quadratic);
}

START_TEST(bad_tolerances_are_refused)
{
    query q = scene_hit(POINT_EDGE);
    scene s = scene_of(&q, (int[]){0, 1, 2});
    tf_motion motion = scene_motion(&s);
    tf_contact contact;
    static const double bad[] = {-1e-9, NAN, INFINITY};
    for (int i = 0; i < 3; i++)
        ck_assert_int_eq(
            tf_quadratic_point_edge(&(tf_tolerances){.distance = bad[i]},
                                    &motion, 0, (int[]){1, 2}, &contact),
            TF_BAD_OPTION);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("linear/quadratic");
    TCase *c = tcase_create("quadratic");
    tcase_add_test(c, a_falling_point_meets_an_edge);
    tcase_add_test(c, a_point_beside_the_center_of_a_turning_edge_is_apart);
    tcase_add_test(c, a_root_outside_does_not_hide_one_inside);
    tcase_add_test(c, motion_within_the_line_is_degenerate);
    tcase_add_test(c, random_queries_are_decided_right);
    tcase_add_test(c, contacts_are_finite_and_in_their_ranges);
    tcase_add_test(c, bad_tolerances_are_refused);
    suite_add_tcase(s, c);
    suite_add_tcase(s, statuses_case_of_doubles("statuses", use_quadratic));
    return s;
}
