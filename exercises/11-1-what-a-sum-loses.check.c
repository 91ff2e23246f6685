#include "check.h"

#include "support/sums.h"
#include "support/support.h"

#include <math.h>
#include <stdio.h>

double what_is_lost(double a, double b);

/// Whether (a + b rounded) + rest is a + b; `missing` is the true rest.
static bool completes(double a, double b, double rest, double *missing)
{
    mpz_t left;
    mpz_init(left);
    sum_add(left, a, 1, 1);
    sum_add(left, b, 1, 1);
    sum_add(left, -(a + b), 1, 1);
    long exponent;
    double fraction = mpz_get_d_2exp(&exponent, left);
    *missing = ldexp(fraction, (int)exponent + SUM_EXPONENT);
    sum_add(left, -rest, 1, 1);
    bool complete = mpz_sgn(left) == 0;
    mpz_clear(left);
    return complete;
}

static void expect(double a, double b)
{
    check_input("a = %a, b = %a", a, b);
    double got, missing;
    check_value(got, what_is_lost(a, b));
    check_that(isfinite(got), "a finite number", "%g", got);
    bool complete = completes(a, b, got, &missing);
    char expected[64];
    snprintf(expected, sizeof expected, "%a", missing);
    check_that(complete, expected, "%a", got);
}

TEST(where_the_first_is_larger)
{
    expect(1, 0x1p-53);
    expect(1, -0x1p-60);
    expect(-0x1.8p100, 0x1.0000000000001p48);
}

TEST(where_the_second_is_larger)
{
    expect(0x1p-53, 1);
    expect(-0x1p-60, 1);
    expect(0x1.0000000000001p48, -0x1.8p100);
    expect(0x1.8000000000001p-2, -0x1.0000000000001p52);
}

TEST(where_nothing_is_lost)
{
    expect(1, 2);
    expect(0.1, -0.1);
    expect(0, 0x1p-1074);
}

TEST(for_any_two)
{
    generator random = generator_new(0);
    for (int i = 0; i < 2000; i++) {
        double a = ldexp(uniform(&random, -1, 1), below(&random, 120));
        double b = ldexp(uniform(&random, -1, 1), below(&random, 120));
        int exponent = below(&random, 1700) - 1000;
        expect(ldexp(a, exponent), ldexp(b, exponent));
    }
}

void run_tests(void)
{
    check_run(1, where_the_first_is_larger);
    check_run(1, where_the_second_is_larger);
    check_run(1, where_nothing_is_lost);
    check_run(1, for_any_two);
}
