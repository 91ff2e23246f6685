#include "arithmetic/published.h"

#include "arithmetic/clamped.h"
#include "arithmetic/functions.h"
#include "support/matrices.h"
#include "support/rational.h"

#include <string.h>

/// The same bits.
static bool same(tf_value a, tf_value b)
{
    return memcmp(&a.number, &b.number, sizeof a.number) == 0 &&
           memcmp(&a.radius, &b.radius, sizeof a.radius) == 0 &&
           a.exponent == b.exponent;
}

static void judge(const matrix *m)
{
    tf_differences differences = matrix_differences(m);
    tf_sign sign = tf_clamped.sign(&differences);
    expect_of_matrix(tf_published.sign(&differences) ==
                         (sign == TF_UNKNOWN ? TF_ZERO : sign),
                     "The sign is not clamped's, unknown as zero", m);
    expect_of_matrix(
        same(tf_published.value(&differences), tf_clamped.value(&differences)),
        "The value is not clamped's", m);
}

START_TEST(the_published_rule_is_clamped_with_zeros_for_unknowns)
{
    generator random = generator_new(1);
    long count = cases(60000);
    for (long i = 0; i < count; i++) {
        matrix m = matrix_any(&random, 1 + below(&random, TF_AXES));
        matrix_nudge(&random, &m, below(&random, 4));
        judge(&m);
    }
}
END_TEST

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
        tf_differences differences = matrix_differences(&m);
        expect_of_matrix(tf_clamped.sign(&differences) == TF_UNKNOWN,
                         "The sign is known", &m);
        judge(&m);
        // The origin is inside: the signs alternate.
        tf_sign sign = oracle_arithmetic.sign(&differences);
        expect_of_matrix(sign != TF_ZERO && sign != inside,
                         "The origin is not inside", &m);
        inside = sign;
    }
}
END_TEST

START_TEST(all_doubles_are_held)
{
    for (int axes = 2; axes <= TF_AXES; axes++)
        ck_assert_int_eq(tf_published.bits[axes], 0);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("published");
    TCase *rule = tcase_create("rule");
    tcase_add_test(rule, the_published_rule_is_clamped_with_zeros_for_unknowns);
    tcase_add_test(rule, the_published_rule_takes_four_unknown_signs_for_zeros);
    tcase_add_test(rule, all_doubles_are_held);
    suite_add_tcase(suite, rule);
    return suite;
}
