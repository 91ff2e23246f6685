#include "simulate/script.h"

#include "support/support.h"

#include <math.h>

/// Of four vertices the middle two.
static const tf_script middle = {.first = 1,
                                 .count = 2,
                                 .begin = 1,
                                 .end = 3,
                                 .center = {1, 1, 0},
                                 .axis = {0, 0, 1},
                                 .turn = 3.141592653589793 / 2,
                                 .shift = {0, 0, 8}};

static tf_body four(void)
{
    tf_body body = {.axes = 3};
    for (int v = 0; v < 4; v++)
        tf_body_add_vertex(&body, (const double[]){v, 1, v});
    return body;
}

static void expect_at(double time, int vertex, double x, double y, double z)
{
    tf_body body = four();
    double position[12] = {0};
    tf_script_place(&middle, &body, time, position);
    const double expected[] = {x, y, z};
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(position[3 * vertex + k], expected[k], 1e-14);
    tf_body_free(&body);
}

START_TEST(a_script_turns_and_shifts)
{
    expect_at(3, 1, 1, 1, 9); // on the axis
    expect_at(3, 2, 1, 2, 10);
    double half = sqrt(0.5);
    expect_at(2, 2, 1 + half, 1 + half, 6);
}
END_TEST

START_TEST(a_script_rests_before_and_after)
{
    expect_at(0, 2, 2, 1, 2);
    expect_at(1, 2, 2, 1, 2);
    expect_at(99, 2, 1, 2, 10);
}
END_TEST

START_TEST(a_script_starts_and_stops_slowly)
{
    expect_at(1.2, 1, 1, 1, 1 + 8 * 0.01 * (3 - 0.2));
    expect_at(2.8, 1, 1, 1, 9 - 8 * 0.01 * (3 - 0.2));
}
END_TEST

START_TEST(vertices_outside_a_script_are_not_placed)
{
    expect_at(3, 0, 0, 0, 0);
    expect_at(3, 3, 0, 0, 0);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/script");
    TCase *tcase = tcase_create("places");
    tcase_add_test(tcase, a_script_turns_and_shifts);
    tcase_add_test(tcase, a_script_rests_before_and_after);
    tcase_add_test(tcase, a_script_starts_and_stops_slowly);
    tcase_add_test(tcase, vertices_outside_a_script_are_not_placed);
    suite_add_tcase(suite, tcase);
    return suite;
}
