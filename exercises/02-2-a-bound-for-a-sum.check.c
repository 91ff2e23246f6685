#include "check.h"

#include "support/sums.h"
#include "support/support.h"

#include <math.h>
#include <stdio.h>

double sum_bound(double a, double b, double c);

/// Whether `bound` is at least the error of the rounded sum, found exactly;
/// `error` is that error, truncated to a double.
static bool holds(double a, double b, double c, double bound, double *error)
{
    mpz_t off, most;
    mpz_init(off);
    mpz_init(most);
    sum_add(off, a, 1, 1);
    sum_add(off, b, 1, 1);
    sum_add(off, c, 1, 1);
    sum_add(off, a + b + c, -1, 1);
    sum_add(most, bound, 1, 1);
    bool holds = mpz_cmpabs(off, most) <= 0;
    long exponent;
    double fraction = fabs(mpz_get_d_2exp(&exponent, off));
    *error = ldexp(fraction, (int)exponent + SUM_EXPONENT);
    mpz_clears(off, most, NULL);
    return holds;
}

static void expect(double a, double b, double c)
{
    double largest = 2.5 * 0x1p-53 * (fabs(a) + fabs(b) + fabs(c));
    check_input("a = %a, b = %a, c = %a", a, b, c);
    double got;
    check_value(got, sum_bound(a, b, c));
    check_that(isfinite(got) && got >= 0, "a finite bound, not negative", "%g",
               got);
    double error;
    bool good = holds(a, b, c, got, &error);
    char expected[100];
    snprintf(expected, sizeof expected,
             "at least %a, the error of the rounded sum", error);
    check_that(good, expected, "%a", got);
    check_that(got <= largest, "at most 2.5 u (|a| + |b| + |c|)",
               "%.3g u (|a| + |b| + |c|)", 2.5 * got / largest);
}

TEST(holds_where_everything_cancels)
{
    expect(1, 0x1p-53, -1);
    expect(1e20, 1, -1e20);
}

TEST(holds_where_both_roundings_err)
{
    expect(1, 0x1p-53, 0x1p-53);
    expect(-1, -0x1p-53, -0x1p-53);
}

TEST(holds_for_any_sum)
{
    generator random = generator_new(0);
    for (int i = 0; i < 500; i++) {
        double term[3];
        for (int j = 0; j < 3; j++)
            term[j] = ldexp(uniform(&random, -1, 1), below(&random, 60));
        expect(term[0], term[1], term[2]);
    }
}

void run_tests(void)
{
    check_run(1, holds_where_everything_cancels);
    check_run(1, holds_where_both_roundings_err);
    check_run(1, holds_for_any_sum);
}
