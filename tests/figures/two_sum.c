#include "figures/numbers.h"

#include "support/rational.h"
#include "support/sums.h"

START_TEST(the_two_doubles_are_the_sum)
{
    const double a = 0x1.921fb54442d18p+1, b = 0x1.5bf0a8b145769p-23;
    char *text = printed(&fig_two_sum);
    double hi = number_of(text, "hi"), lo = number_of(text, "lo");
    mpz_t sum;
    mpz_init(sum);
    sum_add(sum, a, 1, 1);
    sum_add(sum, b, 1, 1);
    ck_assert(rational_is(sum, SUM_EXPONENT, (tf_value){.number = hi}));
    sum_add(sum, -hi, 1, 1);
    ck_assert(rational_is(sum, SUM_EXPONENT, (tf_value){.number = lo}));
    ck_assert_int_ge((int)mpz_sizeinbase(sum, 2) + SUM_EXPONENT - 1, -75);
    expect_number(text, "lo_first",
                  (int)mpz_sizeinbase(sum, 2) + SUM_EXPONENT - 1);
    expect_number(text, "hi_last", 1 - 52);
    sum_add(sum, -lo, 1, 1);
    ck_assert_int_eq(mpz_sgn(sum), 0);
    mpz_clear(sum);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/two_sum", the_two_doubles_are_the_sum);
}
