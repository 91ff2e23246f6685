#include "arithmetic/value.h"

#include "support/support.h"

#include <float.h>
#include <math.h>

static tf_value value_of(double number, double radius, int exponent, int order)
{
    return (tf_value){.number = number,
                      .radius = radius,
                      .exponent = exponent,
                      .order = {order}};
}

START_TEST(the_radius_gains_the_digits_that_scaling_loses)
{
    // Scaled by 2^-1000 the number is 0.6 of the least double.
    tf_value value[] = {value_of(0x1p1000, 1, 0, 0),
                        value_of(0x1.3333333333333p-75, 0x1p-200, 0, 0)};
    tf_values_scale(2, value);
    ck_assert_double_eq(value[0].number, 1);
    ck_assert_int_eq(value[1].exponent, 0);
    double truth = 0x1.3333333333333p-75 * 0x1p75; // in units of 2^-1075
    ck_assert_double_le((value[1].number - value[1].radius) * 0x1p1000 * 0x1p75,
                        truth);
    ck_assert_double_ge((value[1].number + value[1].radius) * 0x1p1000 * 0x1p75,
                        truth);
    ck_assert_double_ge(value[1].radius, DBL_TRUE_MIN);
}
END_TEST

START_TEST(infinitely_smaller_values_become_zero)
{
    tf_value value[] = {value_of(0x1p-900, 0, -900, 0),
                        value_of(0x1p900, 0, 900, 7), value_of(0, 0, 0, 0)};
    tf_values_scale(3, value);
    ck_assert_double_eq(value[0].number, 1);
    ck_assert_double_eq(value[1].number, 0);
    ck_assert_int_eq(value[1].order[0], 0);
    ck_assert_double_eq(value[2].number, 0);

    // The order counts, not the size; alone an infinitesimal is the largest.
    tf_value small[] = {value_of(-3, 0, 0, 9), value_of(5, 0, 0, 8)};
    tf_values_scale(2, small);
    ck_assert_double_eq(small[0].number, 0);
    ck_assert_double_eq(small[1].number, 1.25);
}
END_TEST

START_TEST(the_first_infinitesimal_that_differs_decides)
{
    tf_value value[] = {
        {.number = 9, .order = {4, 7, 2}},
        {.number = 2, .order = {4, 6, 8}},
        {.number = 3, .order = {4, 6, 9}},
        {.number = 1, .order = {4, 6, 8}},
    };
    tf_values_scale(4, value);
    ck_assert_double_eq(value[0].number, 0);
    ck_assert_double_eq(value[1].number, 1);
    ck_assert_double_eq(value[2].number, 0);
    ck_assert_double_eq(value[3].number, 0.5);
}
END_TEST

START_TEST(the_radius_counts_toward_the_size_of_a_value)
{
    tf_value value[] = {value_of(1, 0, 0, 0), value_of(0, 8, 0, 0)};
    tf_values_scale(2, value);
    ck_assert_double_eq(value[0].number, 0.125);
    ck_assert_double_eq(value[1].number, 0);
    ck_assert_double_ge(value[1].radius, 1);
    ck_assert_double_le(value[1].radius, 1 + DBL_TRUE_MIN);

    tf_value wide[] = {value_of(2, 0, 0, 0), value_of(-1, 4, 0, 0)};
    tf_values_scale(2, wide);
    ck_assert_double_eq(wide[0].number, 0.5);
    ck_assert_double_eq(wide[1].number, -0.25);
}
END_TEST

START_TEST(a_radius_grows_only_where_digits_may_be_lost)
{
    tf_value value[] = {value_of(1, DBL_TRUE_MIN, 0, 0)};
    tf_values_scale(1, value);
    ck_assert_double_eq(value[0].radius, DBL_TRUE_MIN);

    tf_value exact[] = {value_of(8, 0, 0, 0), value_of(5, 0, 0, 0)};
    tf_values_scale(2, exact);
    ck_assert_double_eq(exact[1].number, 0.625);
    ck_assert_double_eq(exact[1].radius, 0);
}
END_TEST

START_TEST(values_are_divided_by_a_power_of_two_of_any_size)
{
    for (int exponent = 0; exponent <= 1080; exponent++) {
        tf_value value[] = {value_of(1, 0, 7, 0),
                            value_of(0x1.8p0, 0, 7 - exponent, 0)};
        tf_values_scale(2, value);
        ck_assert_double_eq(value[0].number, 1);
        ck_assert_double_eq(value[1].number, ldexp(0x1.8p0, -exponent));
    }
}
END_TEST

START_TEST(subnormal_numbers_are_scaled_up)
{
    for (int exponent = -1074; exponent <= -1000; exponent++) {
        tf_value value[] = {value_of(ldexp(1, exponent), 0, 0, 0),
                            value_of(ldexp(-3, exponent), 0, -2, 0)};
        tf_values_scale(2, value);
        ck_assert_double_eq(value[0].number, 1);
        ck_assert_double_eq(value[1].number, -0.75);
    }
}
END_TEST

START_TEST(values_that_are_all_zero_are_unchanged)
{
    tf_value value[] = {value_of(0, 0, 5, 3), value_of(0, 0, 6, 0)};
    tf_values_scale(2, value);
    ck_assert_int_eq(value[0].exponent, 5);
    ck_assert_int_eq(value[0].order[0], 3);
    ck_assert_int_eq(value[1].exponent, 6);
}
END_TEST

START_TEST(unknown_values_stay_unknown)
{
    tf_value value[] = {value_of(INFINITY, 0, 0, 0), value_of(8, NAN, 0, 0),
                        value_of(-2, 0, 3, 0)};
    tf_values_scale(3, value);
    ck_assert(!isfinite(value[0].number + value[0].radius));
    ck_assert(!isfinite(value[1].number + value[1].radius));
    ck_assert_double_eq(value[2].number, -1);
    ck_assert_int_eq(value[2].exponent, 0);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("value");
    TCase *values = tcase_create("scaling");
    tcase_add_test(values, the_radius_gains_the_digits_that_scaling_loses);
    tcase_add_test(values, infinitely_smaller_values_become_zero);
    tcase_add_test(values, the_first_infinitesimal_that_differs_decides);
    tcase_add_test(values, the_radius_counts_toward_the_size_of_a_value);
    tcase_add_test(values, a_radius_grows_only_where_digits_may_be_lost);
    tcase_add_test(values, values_are_divided_by_a_power_of_two_of_any_size);
    tcase_add_test(values, subnormal_numbers_are_scaled_up);
    tcase_add_test(values, values_that_are_all_zero_are_unchanged);
    tcase_add_test(values, unknown_values_stay_unknown);
    suite_add_tcase(suite, values);
    return suite;
}
