#include "check.h"

#include "support/sums.h"
#include "support/support.h"

#include <math.h>

double sum_bound(double a, double b, double c);

/// Whether `bound` is at least the error of the rounded sum, found exactly.
static bool holds(double a, double b, double c, double bound)
{
    mpz_t error, most;
    mpz_init(error);
    mpz_init(most);
    sum_add(error, a, 1, 1);
    sum_add(error, b, 1, 1);
    sum_add(error, c, 1, 1);
    sum_add(error, a + b + c, -1, 1);
    sum_add(most, bound, 1, 1);
    bool holds = mpz_cmpabs(error, most) <= 0;
    mpz_clears(error, most, NULL);
    return holds;
}

static void expect(double a, double b, double c)
{
    double largest = 2.5 * 0x1p-53 * (fabs(a) + fabs(b) + fabs(c));
    check_input("a = %a, b = %a, c = %a", a, b, c);
    double got = sum_bound(a, b, c);
    check_that(isfinite(got) && got >= 0, "a finite bound, not negative", "%g",
               got);
    check_that(holds(a, b, c, got), "at least the error of the rounded sum",
               "%a", got);
    check_that(got <= largest, "at most 2.5 u (|a| + |b| + |c|)",
               "%.3g u (|a| + |b| + |c|)", 2.5 * got / largest);
}

START_TEST(holds_where_everything_cancels)
{
    expect(1, 0x1p-53, -1);
    expect(1e20, 1, -1e20);
}
END_TEST

START_TEST(holds_where_both_roundings_err)
{
    expect(1, 0x1p-53, 0x1p-53);
    expect(-1, -0x1p-53, -0x1p-53);
}
END_TEST

START_TEST(holds_for_any_sum)
{
    generator random = generator_new(0);
    for (int i = 0; i < 500; i++) {
        double term[3];
        for (int j = 0; j < 3; j++)
            term[j] = ldexp(uniform(&random, -1, 1), below(&random, 60));
        expect(term[0], term[1], term[2]);
    }
}
END_TEST

void add_tests(TCase *tests)
{
    tcase_add_test(tests, holds_where_everything_cancels);
    tcase_add_test(tests, holds_where_both_roundings_err);
    tcase_add_test(tests, holds_for_any_sum);
}
