#include "arithmetic/two_sum.h"
#include "support/matrices.h"
#include "support/sums.h"

#include <float.h>
#include <math.h>

static void judge_sum(double a, double b)
{
    mpz_t sum;
    mpz_init(sum);
    sum_add(sum, a, 1, 1);
    sum_add(sum, b, 1, 1);
    tf_two two = tf_two_sum(a, b), difference = tf_two_difference(a, -b);
    ck_assert_msg(sum_is(sum, two.hi, two.lo), "%a + %a: %a + %a (seed %llu)",
                  a, b, two.hi, two.lo, (unsigned long long)seed());
    ck_assert_msg(sum_is(sum, difference.hi, difference.lo),
                  "%a - %a: %a + %a (seed %llu)", a, -b, difference.hi,
                  difference.lo, (unsigned long long)seed());
    mpz_clear(sum);
}

START_TEST(sums_of_two_are_exact)
{
    generator random = generator_new(1);
    long count = cases(30000);
    for (long i = 0; i < count; i++) {
        double a = any_double(&random) / 2, b = any_double(&random) / 2;
        judge_sum(a, b);
        // Of like size, of like size but for the sign, and next to each other.
        double near = ldexp(a, below(&random, 120) - 60);
        if (isfinite(a + near))
            judge_sum(a, near * uniform(&random, -1, 1));
        judge_sum(a, -a * uniform(&random, 0.5, 2));
        judge_sum(a, -nextafter(a, 0));
        judge_sum(a, -a);
    }
}
END_TEST

START_TEST(sums_beside_a_tie_are_exact)
{
    generator random = generator_new(2);
    long count = cases(10000);
    for (long i = 0; i < count; i++) {
        double a = 1 + below(&random, 4) * DBL_EPSILON;
        double half = (1 + below(&random, 4)) * DBL_EPSILON / 4;
        int exponent = below(&random, 2040) - 1020;
        a = ldexp(below(&random, 2) ? a : -a, exponent);
        half = ldexp(half, exponent);
        judge_sum(a, half);
        judge_sum(a, nextafter(half, 0));
        judge_sum(a, nextafter(half, 1));
        judge_sum(half, a);
    }
}
END_TEST

START_TEST(sums_at_the_ends_of_the_range_are_exact)
{
    static const double ends[] = {
        0,           -0.0,     DBL_TRUE_MIN, DBL_MIN - DBL_TRUE_MIN, DBL_MIN, 1,
        DBL_MAX / 2, 0x1p1023, DBL_MAX};
    int count = (int)(sizeof ends / sizeof *ends);
    for (int i = 0; i < count; i++)
        for (int j = 0; j < count; j++) {
            judge_sum(ends[i], -ends[j]);
            judge_sum(-ends[i], ends[j]);
            if (isfinite(ends[i] + ends[j]))
                judge_sum(ends[i], ends[j]);
        }
}
END_TEST

Suite *suite(void)
{
    Suite *two_sum = suite_create("two_sum");
    TCase *sums = tcase_create("sums of two");
    tcase_add_test(sums, sums_of_two_are_exact);
    tcase_add_test(sums, sums_beside_a_tie_are_exact);
    tcase_add_test(sums, sums_at_the_ends_of_the_range_are_exact);
    suite_add_tcase(two_sum, sums);
    return two_sum;
}
