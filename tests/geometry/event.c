#include "geometry/event.h"

#include "support/support.h"

#include <signal.h>

START_TEST(a_worldline_joins_two_positions)
{
    tf_worldline line =
        tf_worldline_between(3, (double[]){1, 2, 3}, (double[]){4, 5, 6});
    for (int t = 0; t < 2; t++) {
        ck_assert_int_eq(line.at[t].t, t);
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq(line.at[t].x[k], 1 + k + 3 * t);
    }
}
END_TEST

START_TEST(a_worldline_of_the_plane_reads_two_coordinates)
{
    double start[2] = {1, 2}, end[2] = {4, 5};
    tf_worldline line = tf_worldline_between(2, start, end);
    ck_assert_double_eq(line.at[0].x[1], 2);
    ck_assert_double_eq(line.at[1].x[1], 5);
    ck_assert_double_eq(line.at[0].x[2], 0);
    ck_assert_double_eq(line.at[1].x[2], 0);
}
END_TEST

START_TEST(four_axes_break_the_contract)
{
    double x[4] = {0, 0, 0, 0};
    tf_worldline_between(4, x, x);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("geometry/event");
    TCase *tcase = tcase_create("worldline");
    tcase_add_test(tcase, a_worldline_joins_two_positions);
    tcase_add_test(tcase, a_worldline_of_the_plane_reads_two_coordinates);
    tcase_add_test_raise_signal(tcase, four_axes_break_the_contract, SIGABRT);
    suite_add_tcase(suite, tcase);
    return suite;
}
