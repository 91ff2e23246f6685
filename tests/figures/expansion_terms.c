#include "figures/numbers.h"

#include "support/matrices.h"
#include "support/sums.h"

/// The determinant in units of 2^SUM_EXPONENT.
static void find_determinant(mpz_t determinant)
{
    static const double entry[] = {
        0x1.39adc5cd900e1p-2,  -0x1.5fd7e4fab497p-4, -0x1.382988f3c19d2p-2,
        -0x1.72b9bad814c5fp-2, 0x1.08b61d7e26e86p-4, 0x1.5c960fdb4427ap-2,
        -0x1.7426e4871b6b3p-2, 0x1.a16e455e5683p-4,  0x1.725a4884d51d7p-2};
    matrix m = matrix_of(3, entry);
    tf_differences differences = matrix_differences(&m);
    sum_determinant(determinant, &differences);
}

START_TEST(bits_and_terms_are_counted)
{
    char *text = printed(&fig_expansion_terms);
    mpz_t determinant;
    mpz_init(determinant);
    find_determinant(determinant);
    int first = (int)mpz_sizeinbase(determinant, 2) + SUM_EXPONENT;
    int last = (int)mpz_scan1(determinant, 0) + SUM_EXPONENT;
    expect_number(text, "last_bit", last);

    // A last term that is a power of two may be just above the sum.
    double found = number_of(text, "first_bit");
    ck_assert_msg(found == first - 1 || found == first,
                  "the first bit is %g, not %d", found, first - 1);
    ck_assert_double_ge(number_of(text, "terms"), (first - last) / 53.0);
    ck_assert_double_le(number_of(text, "terms"), 24);
    ck_assert_double_le(number_of(text, "minor_terms"), 4);
    ck_assert_double_le(number_of(text, "part_terms"), 8);

    long exponent;
    double value = mpz_get_d_2exp(&exponent, determinant);
    value = ldexp(value, (int)exponent + SUM_EXPONENT);
    ck_assert_double_le(fabs(number_of(text, "value") - value),
                        1e-14 * fabs(value));
    double bound = number_of(text, "bound");
    ck_assert_double_lt(fabs(value), bound);
    ck_assert_double_lt(fabs(value - number_of(text, "estimate")), bound);
    ck_assert_double_gt(value * number_of(text, "last"), 0);
    mpz_clear(determinant);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/expansion_terms", bits_and_terms_are_counted);
}
