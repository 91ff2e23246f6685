#include "arithmetic/clamped.h"

#include "arithmetic/functions.h"
#include "support/estimates.h"
#include "support/rational.h"
#include "support/sums.h"

#include <float.h>
#include <math.h>

static void judge_signs(const matrix *m, const judged_estimate *j)
{
    tf_differences differences = matrix_differences(m);
    tf_sign sign = tf_clamped.sign(&differences);
    tf_sign report = sign == TF_UNKNOWN ? TF_ZERO : sign;
    expect_of_matrix(sign == TF_UNKNOWN || sign == sum_sign(j->truth),
                     "The sign is known and wrong", m);
    expect_of_matrix(tf_published.sign(&differences) == report,
                     "The report's sign is not clamped's, unknown as zero", m);
}

static void judge(const matrix *m)
{
    judged_estimate j;
    judged_estimate_init(&j, m);
    judge_signs(m, &j);
    expect_of_matrix(radius_is_kept(&j), "The error is beyond the radius", m);
    expect_of_matrix(
        !(j.value.radius < 0) && j.value.exponent == 0 &&
            (j.value.number == j.estimate.number || isnan(j.estimate.number)),
        "The value is not the estimate", m);
    judged_estimate_clear(&j);
}

// Signs -----------------------------------------------------------------------

static tf_sign clamped_sign(const matrix *m)
{
    tf_differences differences = matrix_differences(m);
    return tf_clamped.sign(&differences);
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
            judge(&m);
            expect_of_matrix(true_sign(&m) == TF_ZERO ||
                                 clamped_sign(&m) != TF_UNKNOWN,
                             "The sign is not known", &m);
        } while (next_signs(n * n, entry));
    }
}
END_TEST

START_TEST(signs_and_values_hold_on_hard_matrices)
{
    generator random = generator_new(2);
    long count = cases(60000);
    for (long i = 0; i < count; i++) {
        matrix m = matrix_any(&random, 1 + below(&random, TF_AXES));
        matrix_nudge(&random, &m, below(&random, 4));
        judge(&m);
    }
}
END_TEST

START_TEST(signs_and_values_hold_where_products_underflow)
{
    generator random = generator_new(3);
    long count = cases(40000);
    for (long i = 0; i < count; i++) {
        int n = 2 + below(&random, 2);
        matrix m = matrix_close(&random, n, -1080 + below(&random, 80));
        judge(&m);
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
        judge(&m);
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
        judge(&m);
        expect_of_matrix(clamped_sign(&m) == TF_UNKNOWN,
                         "The sign is known despite overflow", &m);
    }
    // But a single difference keeps its sign.
    matrix m = matrix_of(1, (double[]){DBL_MAX});
    m.from[0].x[0] = -DBL_MAX;
    expect_of_matrix(clamped_sign(&m) == TF_POSITIVE,
                     "The sign of an overflowing difference is wrong", &m);
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

static void expect_certain_zeros(generator *random, int exponent,
                                 tf_sign otherwise)
{
    for (int n = 1; n <= TF_AXES; n++)
        for (int pattern = 0; pattern < 1 << n * n; pattern++) {
            matrix m = patterned(random, n, pattern, exponent);
            judge(&m);
            bool zero = true_sign(&m) == TF_ZERO;
            tf_sign expected = zero                     ? TF_ZERO
                               : n == 1                 ? TF_POSITIVE
                               : otherwise < TF_UNKNOWN ? true_sign(&m)
                                                        : otherwise;
            expect_of_matrix(clamped_sign(&m) == expected,
                             "A zero is not told from an unknown", &m);
        }
}

START_TEST(a_zero_in_each_term_is_certified)
{
    generator random = generator_new(5);
    static const int exponents[] = {0, -150, -300, 150, 300};
    for (int i = 0; i < 5; i++)
        expect_certain_zeros(&random, exponents[i], TF_ZERO);
}
END_TEST

START_TEST(a_zero_made_by_underflow_is_not_certified)
{
    generator random = generator_new(6);
    static const int exponents[] = {-538, -600, -700, -1000, -1022};
    for (int i = 0; i < 5; i++)
        expect_certain_zeros(&random, exponents[i], TF_UNKNOWN);
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
        judge(&m);
        expect_of_matrix(clamped_sign(&m) == TF_UNKNOWN,
                         "The sign is known despite cancelling", &m);
    }
}
END_TEST

// The report's rule -----------------------------------------------------------

START_TEST(the_published_rule_takes_four_unknown_signs_for_zeros)
{
    // Three vertices of a tetrahedron around the origin at t = 0, one at t = 1.
    static const double vertex[4][TF_AXES] = {
        {0x1.39adc5cd900e1p-2, -0x1.5fd7e4fab497p-4, -0x1.382988f3c19d2p-2},
        {-0x1.72b9bad814c5fp-2, 0x1.08b61d7e26e86p-4, 0x1.5c960fdb4427ap-2},
        {-0x1.7426e4871b6b3p-2, 0x1.a16e455e5683p-4, 0x1.725a4884d51d7p-2},
        {0x1.31d6b0a9f41e9p-2, -0x1.b4c2778e24ec8p-5, -0x1.1f9303fc4c4acp-2}};
    tf_sign inside = TF_UNKNOWN;
    for (int left_out = 0; left_out < 4; left_out++) {
        double entry[TF_AXES * TF_AXES];
        for (int i = 0, row = 0; i < 4; i++)
            for (int k = 0; i != left_out && k < TF_AXES; k++)
                entry[row++] = vertex[i][k];
        matrix m = matrix_of(3, entry);
        judge(&m); // the report's sign is zero where clamped's is unknown
        expect_of_matrix(clamped_sign(&m) == TF_UNKNOWN, "The sign is known",
                         &m);
        // The origin is inside: the signs alternate.
        tf_sign sign = true_sign(&m);
        expect_of_matrix(sign != TF_ZERO && sign != inside,
                         "The origin is not inside", &m);
        inside = sign;
    }
}
END_TEST

START_TEST(clamped_arithmetics_hold_all_doubles)
{
    for (int axes = 2; axes <= TF_AXES; axes++) {
        ck_assert_int_eq(tf_clamped.bits[axes], 0);
        ck_assert_int_eq(tf_published.bits[axes], 0);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *clamped = suite_create("clamped");
    TCase *signs = tcase_create("signs");
    tcase_add_test(signs, signs_of_small_integers_are_known);
    tcase_add_test(signs, signs_and_values_hold_on_hard_matrices);
    tcase_add_test(signs, signs_and_values_hold_where_products_underflow);
    tcase_add_test(signs, signs_hold_where_products_overflow);
    tcase_add_test(signs, signs_are_unknown_where_products_overflow);
    tcase_add_test(signs, clamped_arithmetics_hold_all_doubles);
    suite_add_tcase(clamped, signs);
    TCase *zeros = tcase_create("zeros");
    tcase_add_test(zeros, a_zero_in_each_term_is_certified);
    tcase_add_test(zeros, a_zero_made_by_underflow_is_not_certified);
    tcase_add_test(zeros, a_zero_made_by_cancelling_is_not_certified);
    suite_add_tcase(clamped, zeros);
    TCase *report = tcase_create("the report's rule");
    tcase_add_test(report,
                   the_published_rule_takes_four_unknown_signs_for_zeros);
    suite_add_tcase(clamped, report);
    return clamped;
}
