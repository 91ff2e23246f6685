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
    expect_of_matrix(sign == TF_UNKNOWN || sign == sum_sign(j->truth),
                     "The sign is known and wrong", m);
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

START_TEST(all_doubles_are_held)
{
    for (int axes = 2; axes <= TF_AXES; axes++)
        ck_assert_int_eq(tf_clamped.bits[axes], 0);
}
END_TEST

Suite *suite(void)
{
    Suite *clamped = suite_create("clamped");
    estimates_add(clamped, use);
    TCase *range = tcase_create("range");
    tcase_add_test(range, all_doubles_are_held);
    suite_add_tcase(clamped, range);
    return clamped;
}
