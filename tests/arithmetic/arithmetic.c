#include "arithmetic/arithmetic.h"

#include "arithmetic/functions.h"
#include "support/support.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <signal.h>

static void expect_holds(int bits, int axes, double x, bool expected)
{
    // The other number of axes has another limit, to be left alone.
    tf_arithmetic arithmetic = {.bits = {[2] = 7, [3] = 7}};
    arithmetic.bits[axes] = bits;
    bool held = tf_arithmetic_holds(&arithmetic, axes, x);
    ck_assert_msg(held == expected, "%d bits, %d axes: %a is%s held", bits,
                  axes, x, held ? "" : " not");
}

static void expect_holds_both_signs(int bits, double x, bool expected)
{
    for (int axes = 2; axes <= 3; axes++) {
        expect_holds(bits, axes, x, expected);
        expect_holds(bits, axes, -x, expected);
    }
}

START_TEST(integers_below_the_limit_are_held)
{
    static const int limits[] = {1, 19, 30, 40, 52, 53, 62, 1000};
    for (int i = 0; i < (int)(sizeof limits / sizeof *limits); i++) {
        int bits = limits[i];
        double limit = ldexp(1, bits);
        // Beyond 53 bits the next number below is not the next integer.
        double last = bits <= 53 ? limit - 1 : nextafter(limit, 0);
        expect_holds_both_signs(bits, 0, true);
        expect_holds_both_signs(bits, 1, true);
        expect_holds_both_signs(bits, last, true);
        expect_holds_both_signs(bits, limit, false);
        expect_holds_both_signs(bits, limit + 1, false);
        expect_holds_both_signs(bits, nextafter(limit, INFINITY), false);
    }
}
END_TEST

START_TEST(only_integers_are_held)
{
    static const double others[] = {0.5,
                                    DBL_TRUE_MIN,
                                    DBL_MIN,
                                    0x1.fffffffffffffp-1,
                                    0x1.0000000000001p0,
                                    0x1.0000000000001p18,
                                    0x1.fffffffffffffp18,
                                    0x1.fffffffffffffp51,
                                    DBL_MAX,
                                    INFINITY,
                                    NAN};
    for (int i = 0; i < (int)(sizeof others / sizeof *others); i++) {
        expect_holds_both_signs(19, others[i], false);
        expect_holds_both_signs(53, others[i], false);
    }
}
END_TEST

START_TEST(no_limit_holds_finite_doubles)
{
    static const double finite[] = {0, DBL_TRUE_MIN, DBL_MIN, 0.1, 1, DBL_MAX};
    for (int i = 0; i < (int)(sizeof finite / sizeof *finite); i++)
        expect_holds_both_signs(0, finite[i], true);
    expect_holds_both_signs(0, INFINITY, false);
    expect_holds_both_signs(0, NAN, false);
}
END_TEST

// What is public of an arithmetic ---------------------------------------------

START_TEST(name_and_bits_are_those_of_the_arithmetic)
{
    tf_arithmetic arithmetic = {.name = "any", .bits = {[2] = 17, [3] = 5}};
    ck_assert_str_eq(tf_arithmetic_name(&arithmetic), "any");
    ck_assert_int_eq(tf_arithmetic_bits(&arithmetic, 2), 17);
    ck_assert_int_eq(tf_arithmetic_bits(&arithmetic, 3), 5);
}
END_TEST

START_TEST(other_numbers_of_axes_have_no_bits)
{
    static const int axes[] = {-1, 0, 1, 4, INT_MIN, INT_MAX};
    tf_arithmetic arithmetic = {.bits = {9, 9, 9, 9}};
    for (int i = 0; i < (int)(sizeof axes / sizeof *axes); i++)
        ck_assert_int_eq(tf_arithmetic_bits(&arithmetic, axes[i]), -1);
}
END_TEST

START_TEST(a_null_arithmetic_breaks_the_contract)
{
    tf_arithmetic_name(NULL);
}
END_TEST

Suite *suite(void)
{
    Suite *arithmetic = suite_create("arithmetic");
    TCase *range = tcase_create("range");
    tcase_add_test(range, integers_below_the_limit_are_held);
    tcase_add_test(range, only_integers_are_held);
    tcase_add_test(range, no_limit_holds_finite_doubles);
    suite_add_tcase(arithmetic, range);
    TCase *public = tcase_create("public");
    tcase_add_test(public, name_and_bits_are_those_of_the_arithmetic);
    tcase_add_test(public, other_numbers_of_axes_have_no_bits);
    tcase_add_test_raise_signal(public, a_null_arithmetic_breaks_the_contract,
                                SIGABRT);
    suite_add_tcase(arithmetic, public);
    return arithmetic;
}
