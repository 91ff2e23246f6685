#include "writers/decimal.h"

#include "support/matrices.h"
#include "support/support.h"

#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void expect_spelled(double number)
{
    char text[TF_DECIMAL_ROOM + 1], wanted[50];
    *tf_decimal_double(text, number) = '\0';
    int digits = 15;
    do
        snprintf(wanted, sizeof wanted, "%.*g", digits, number);
    while (strtod(wanted, NULL) != number && digits++ < 17);
    ck_assert_msg(strcmp(text, wanted) == 0, "%a: '%s', not '%s'", number, text,
                  wanted);
}

/// Numbers around one, up to some units in the last place.
static void expect_spelled_around(double number)
{
    for (int i = -3; i <= 3; i++) {
        double x = number;
        for (int k = 0; k < abs(i); k++)
            x = nextafter(x, i < 0 ? -INFINITY : INFINITY);
        expect_spelled(x);
        expect_spelled(-x);
    }
}

START_TEST(boundaries_are_spelled_as_by_printf)
{
    static const double numbers[] = {0,       1e-4,     0x1p49,    0x1p53,
                                     DBL_MAX, DBL_MIN,  0x1p-1074, 0.5,
                                     1.0 / 3, 123456789};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        expect_spelled_around(numbers[i]);
    for (int i = -20; i < 20; i++)
        expect_spelled_around(pow(10, i));
    for (int i = -70; i < 70; i++)
        expect_spelled_around(ldexp(1, i));
    for (int i = 1; i < 10000; i++) {
        expect_spelled(i);
        expect_spelled(i / 1000.0);
    }
}
END_TEST

// Half of the last digit: of two, the even one is nearest.
START_TEST(ties_are_spelled_as_by_printf)
{
    generator random = generator_new(8);
    for (long i = 0; i < cases(20000); i++) {
        double whole = floor(uniform(&random, 0x1p46, 0x1p49));
        expect_spelled(whole + 0.5);
        expect_spelled(floor(whole / 64) + below(&random, 64) / 64.0);
        expect_spelled(floor(whole / 1024) + below(&random, 1024) / 1024.0);
    }
}
END_TEST

START_TEST(random_numbers_are_spelled_as_by_printf)
{
    generator random = generator_new(9);
    for (long i = 0; i < cases(100000); i++) {
        expect_spelled(any_double(&random));
        expect_spelled(uniform(&random, -1, 1));
        expect_spelled((double)(float)uniform(&random, -1, 1));
        expect_spelled(ldexp(uniform(&random, -1, 1), below(&random, 80) - 20));
    }
}
END_TEST

START_TEST(integers_are_spelled)
{
    static const int64_t numbers[] = {
        0,   1,           -1,         9,         10,       99,
        100, -2147483648, 4294967295, INT64_MAX, INT64_MIN};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        char text[TF_DECIMAL_ROOM + 1], wanted[50];
        *tf_decimal_integer(text, numbers[i]) = '\0';
        snprintf(wanted, sizeof wanted, "%" PRId64, numbers[i]);
        ck_assert_str_eq(text, wanted);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("writers/decimal");
    TCase *tcase = tcase_create("decimals");
    tcase_add_test(tcase, boundaries_are_spelled_as_by_printf);
    tcase_add_test(tcase, ties_are_spelled_as_by_printf);
    tcase_add_test(tcase, random_numbers_are_spelled_as_by_printf);
    tcase_add_test(tcase, integers_are_spelled);
    suite_add_tcase(suite, tcase);
    return suite;
}
