// Wide integers, against those of GMP.
#include "arithmetic/wide.h"

#include "support/support.h"

#include <float.h>
#include <gmp.h>
#include <limits.h>
#include <math.h>

static void take(const tf_wide *a, mpz_t to)
{
    mpz_import(to, (size_t)a->count, -1, sizeof *a->word, 0, 0, a->word);
    if (a->sign == TF_NEGATIVE)
        mpz_neg(to, to);
}

static void expect(const tf_wide *a, const mpz_t expected)
{
    mpz_t own;
    mpz_init(own);
    take(a, own);
    ck_assert_int_eq(mpz_cmp(own, expected), 0);
    ck_assert_int_eq(a->sign, mpz_sgn(expected));
    ck_assert(a->count == 0 || a->word[a->count - 1] != 0);
    mpz_clear(own);
}

/// A product of doubles of any sizes, or zero.
static void make(generator *random, tf_wide *a)
{
    tf_wide other;
    tf_wide_set(below(random, 9) == 0
                    ? 0
                    : ldexp(uniform(random, -1, 1), below(random, 900)),
                -60, a);
    for (int i = below(random, 3); i > 0; i--) {
        tf_wide copy = *a;
        tf_wide_set(ldexp(uniform(random, -1, 1), below(random, 900)), -60,
                    &other);
        tf_wide_multiply(&copy, &other, a);
    }
}

START_TEST(sums_and_products_are_those_of_gmp)
{
    generator random = generator_new(1);
    mpz_t x, y, z;
    mpz_inits(x, y, z, NULL);
    for (long i = cases(20000); i > 0; i--) {
        tf_wide a, b, c;
        make(&random, &a);
        make(&random, &b);
        if (below(&random, 8) == 0)
            b = a;
        take(&a, x);
        take(&b, y);
        ck_assert_int_eq(tf_wide_compare(&a, &b),
                         (mpz_cmp(x, y) > 0) - (mpz_cmp(x, y) < 0));
        mpz_add(z, x, y);
        tf_wide_add(&a, &b, &c);
        expect(&c, z);
        mpz_sub(z, x, y);
        tf_wide_subtract(&a, &b, &c);
        expect(&c, z);
        mpz_mul(z, x, y);
        tf_wide_multiply(&a, &b, &c);
        expect(&c, z);
        tf_wide_subtract(&a, &b, &a);
        mpz_sub(z, x, y);
        expect(&a, z);
    }
    mpz_clears(x, y, z, NULL);
}
END_TEST

START_TEST(doubles_come_back_as_they_are)
{
    static const double some[] = {
        1,        -3,      0.75,        DBL_TRUE_MIN,
        -DBL_MIN, DBL_MAX, 0x1.8p-1070, -0x1.fffffffffffffp-1022,
        0};
    for (int i = 0; i < 9; i++)
        for (int unit = -1074; unit <= -1000; unit += 37) {
            int lowest = tf_lowest_bit(some[i]), exponent;
            int own = lowest < unit ? lowest : unit;
            tf_wide a;
            tf_wide_set(some[i], own, &a);
            double number = tf_wide_round(&a, &exponent);
            ck_assert(ldexp(number, exponent + own) == some[i]);
        }
    ck_assert_int_eq(tf_lowest_bit(0), INT_MAX);
    ck_assert_int_eq(tf_lowest_bit(-0.0), INT_MAX);
    ck_assert_int_eq(tf_lowest_bit(-12), 2);
    ck_assert_int_eq(tf_lowest_bit(DBL_TRUE_MIN), -1074);
    ck_assert_int_eq(tf_lowest_bit(DBL_MAX), 971);
}
END_TEST

START_TEST(the_largest_products_fit)
{
    tf_wide a, b, product;
    tf_wide_set(DBL_MAX, -1074, &a);
    product = a;
    for (int i = 1; i < 6; i++) {
        b = product;
        tf_wide_multiply(&a, &b, &product);
    }
    int exponent;
    double number = tf_wide_round(&product, &exponent);
    frexp(number, &(int){0});
    ck_assert_int_eq(ilogb(number) + exponent, 6 * 2098 - 1);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("arithmetic/wide");
    TCase *tcase = tcase_create("wide");
    tcase_add_test(tcase, sums_and_products_are_those_of_gmp);
    tcase_add_test(tcase, doubles_come_back_as_they_are);
    tcase_add_test(tcase, the_largest_products_fit);
    suite_add_tcase(suite, tcase);
    return suite;
}
