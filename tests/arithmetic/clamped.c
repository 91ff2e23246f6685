#include "arithmetic/clamped.h"

#include "arithmetic/functions.h"
#include "support/estimates.h"
#include "support/rational.h"
#include "support/sums.h"

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

static tf_sign clamped_sign(const matrix *m)
{
    tf_differences differences = matrix_differences(m);
    return tf_clamped.sign(&differences);
}

static bool decides(const matrix *m)
{
    return clamped_sign(m) != TF_UNKNOWN;
}

static void use(void)
{
    static const estimate_test test = {judge, decides};
    estimates_use(&test);
}

// Both arithmetics ------------------------------------------------------------

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
        expect_of_matrix(!decides(&m), "The sign is known", &m);
        // The origin is inside: the signs alternate.
        tf_differences differences = matrix_differences(&m);
        tf_sign sign = oracle_arithmetic.sign(&differences);
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
    estimates_add(clamped, use);
    TCase *both = tcase_create("both");
    tcase_add_test(both, the_published_rule_takes_four_unknown_signs_for_zeros);
    tcase_add_test(both, clamped_arithmetics_hold_all_doubles);
    suite_add_tcase(clamped, both);
    return clamped;
}
