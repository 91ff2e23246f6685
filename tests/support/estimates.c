#include "support/estimates.h"

#include "arithmetic/clamped.h"
#include "arithmetic/functions.h"
#include "support/rational.h"
#include "support/sums.h"

#include <float.h>
#include <math.h>

void judged_estimate_init(judged_estimate *j, const matrix *m)
{
    tf_differences differences = matrix_differences(m);
    j->estimate = tf_differences_estimate(&differences);
    j->value = tf_clamped.value(&differences);
    mpz_inits(j->truth, j->error, NULL);
    sum_determinant(j->truth, &differences);
    if (isfinite(j->estimate.number)) {
        mpz_set(j->error, j->truth);
        sum_add(j->error, -1, j->estimate.number, 1);
        mpz_abs(j->error, j->error);
    }
}

void judged_estimate_clear(judged_estimate *j)
{
    mpz_clears(j->truth, j->error, NULL);
}

/// Whether the error is at most a + b c.
static bool error_within(const judged_estimate *j, double a, double b, double c)
{
    mpz_t bound;
    mpz_init(bound);
    sum_add(bound, a, 1, 1);
    sum_add(bound, b, c, 1);
    bool within = mpz_cmp(j->error, bound) <= 0;
    mpz_clear(bound);
    return within;
}

double last_place(double x)
{
    return x == 0 ? 0 : fmax(ldexp(1, ilogb(x) - 52), DBL_TRUE_MIN);
}

bool bound_is_kept(const judged_estimate *j)
{
    tf_estimate e = j->estimate;
    return !isfinite(e.number) || !isfinite(e.bound) ||
           error_within(j, e.bound, last_place(e.number), 0.5);
}

bool radius_is_kept(const judged_estimate *j)
{
    tf_value v = j->value;
    return !isfinite(v.number) || !isfinite(v.radius) ||
           error_within(j, v.radius, fabs(v.number), DBL_EPSILON / 2);
}

bool estimate_is_true(const judged_estimate *j)
{
    tf_estimate e = j->estimate;
    tf_sign sign = sum_sign(j->truth);
    if (e.number > e.bound)
        return sign == TF_POSITIVE;
    if (-e.number > e.bound)
        return sign == TF_NEGATIVE;
    return e.number != 0 || e.bound != 0 || sign == TF_ZERO;
}

matrix matrix_close(generator *random, int n, int exponent)
{
    matrix m =
        below(random, 2) ? matrix_flat(random, n) : matrix_singular(random, n);
    int factors = n == 3 ? 2 + below(random, 2) : n;
    for (int j = 0; j < n; j++) {
        int own = exponent / factors + below(random, 40) - 20;
        // With two factors, the third column is as large or small as it likes.
        matrix_scale(&m, j, j < factors ? own : below(random, 1800) - 900);
    }
    matrix_nudge(random, &m, below(random, 3));
    return m;
}

// The tests -------------------------------------------------------------------

static const estimate_test *tried;

void estimates_use(const estimate_test *test)
{
    tried = test;
}

static tf_sign true_sign(const matrix *m)
{
    tf_differences differences = matrix_differences(m);
    return oracle_arithmetic.sign(&differences);
}

START_TEST(signs_of_small_integers_are_known)
{
    for (int n = 1; n <= TF_AXES; n++) {
        double entry[TF_AXES * TF_AXES] = {-1, -1, -1, -1, -1, -1, -1, -1, -1};
        do {
            matrix m = matrix_of(n, entry);
            tried->judge(&m);
            expect_of_matrix(true_sign(&m) == TF_ZERO || tried->decides(&m),
                             "The sign is not decided", &m);
        } while (next_signs(n * n, entry));
    }
}
END_TEST

START_TEST(signs_and_bounds_hold_on_hard_matrices)
{
    generator random = generator_new(2);
    long count = cases(60000);
    for (long i = 0; i < count; i++) {
        matrix m = matrix_any(&random, 1 + below(&random, TF_AXES));
        matrix_nudge(&random, &m, below(&random, 4));
        tried->judge(&m);
    }
}
END_TEST

START_TEST(signs_and_bounds_hold_where_products_underflow)
{
    generator random = generator_new(3);
    long count = cases(40000);
    for (long i = 0; i < count; i++) {
        int n = 2 + below(&random, 2);
        matrix m = matrix_close(&random, n, -1080 + below(&random, 80));
        tried->judge(&m);
    }
}
END_TEST

START_TEST(signs_hold_where_products_overflow)
{
    generator random = generator_new(4);
    long count = cases(20000);
    for (long i = 0; i < count; i++) {
        int n = 2 + below(&random, 2);
        matrix m = matrix_close(&random, n, 980 + below(&random, 60));
        tried->judge(&m);
    }
}
END_TEST

START_TEST(signs_are_unknown_where_products_overflow)
{
    static const double huge[][4] = {{DBL_MAX, 1, -1, DBL_MAX},
                                     {0x1p512, 1, 1, 0x1p512},
                                     {DBL_MAX, DBL_MAX, DBL_MAX, -DBL_MAX},
                                     {0x1p600, 0x1p600, 0x1p600, 0x1p600}};
    for (int i = 0; i < (int)(sizeof huge / sizeof *huge); i++) {
        matrix m = matrix_of(2, huge[i]);
        tried->judge(&m);
        expect_of_matrix(!tried->decides(&m),
                         "The sign is decided despite overflow", &m);
    }
    // But a single difference keeps its sign.
    matrix m = matrix_of(1, (double[]){DBL_MAX});
    m.from[0].x[0] = -DBL_MAX;
    tried->judge(&m);
    expect_of_matrix(tried->decides(&m),
                     "An overflowing difference has no sign", &m);
}
END_TEST

// Zeros -----------------------------------------------------------------------

/// Random entries of about 2^exponent where `pattern` has a bit, zeros
/// elsewhere: a determinant that is zero just if each of its terms is.
static matrix patterned(generator *random, int n, int pattern, int exponent)
{
    double entry[TF_AXES * TF_AXES] = {0};
    for (int k = 0; k < n * n; k++)
        if (pattern & 1 << k)
            entry[k] = ldexp(uniform(random, 1, 2), exponent);
    return matrix_of(n, entry);
}

/// `otherwise`: whether signs that are not zero are decided, too; where n = 1
/// they are.
static void expect_certain_zeros(generator *random, int exponent,
                                 bool otherwise)
{
    for (int n = 1; n <= TF_AXES; n++)
        for (int pattern = 0; pattern < 1 << n * n; pattern++) {
            matrix m = patterned(random, n, pattern, exponent);
            tried->judge(&m);
            bool zero = true_sign(&m) == TF_ZERO;
            expect_of_matrix(tried->decides(&m) ==
                                 (zero || n == 1 || otherwise),
                             "A zero is not told from an unknown", &m);
        }
}

START_TEST(a_zero_in_each_term_is_certified)
{
    generator random = generator_new(5);
    static const int exponents[] = {0, -150, -300, 150, 300};
    for (int i = 0; i < 5; i++)
        expect_certain_zeros(&random, exponents[i], true);
}
END_TEST

START_TEST(a_zero_made_by_underflow_is_not_certified)
{
    generator random = generator_new(6);
    static const int exponents[] = {-538, -600, -700, -1000, -1022};
    for (int i = 0; i < 5; i++)
        expect_certain_zeros(&random, exponents[i], false);
}
END_TEST

START_TEST(a_zero_made_by_cancelling_is_not_certified)
{
    static const double cancelling[][9] = {
        {1, 1, 0, 1, 1, 0, 0, 0, 1},
        {1, 1, 1, 1, 1, 1, 1, 1, 1},
        {1, 2, 3, 4, 5, 6, 7, 8, 9},
        {0x1p-300, 0x1p-300, 0, 0x1p-300, 0x1p-300, 0, 0, 0, 1}};
    for (int i = 0; i < (int)(sizeof cancelling / sizeof *cancelling); i++) {
        matrix m = matrix_of(3, cancelling[i]);
        tried->judge(&m);
        expect_of_matrix(!tried->decides(&m),
                         "The sign is decided despite cancelling", &m);
    }
}
END_TEST

void estimates_add(Suite *suite, void (*use)(void))
{
    TCase *signs = tcase_create("signs");
    tcase_add_checked_fixture(signs, use, NULL);
    tcase_add_test(signs, signs_of_small_integers_are_known);
    tcase_add_test(signs, signs_and_bounds_hold_on_hard_matrices);
    tcase_add_test(signs, signs_and_bounds_hold_where_products_underflow);
    tcase_add_test(signs, signs_hold_where_products_overflow);
    tcase_add_test(signs, signs_are_unknown_where_products_overflow);
    suite_add_tcase(suite, signs);
    TCase *zeros = tcase_create("zeros");
    tcase_add_checked_fixture(zeros, use, NULL);
    tcase_add_test(zeros, a_zero_in_each_term_is_certified);
    tcase_add_test(zeros, a_zero_made_by_underflow_is_not_certified);
    tcase_add_test(zeros, a_zero_made_by_cancelling_is_not_certified);
    suite_add_tcase(suite, zeros);
}
