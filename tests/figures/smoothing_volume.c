#include "figures/numbers.h"

START_TEST(sideways_keeps_the_volume)
{
    char *text = printed(&fig_smoothing_volume);
    expect_number(text, "passes", 60);
    ck_assert_double_lt(number_of(text, "plain"), 1);
    ck_assert_double_lt(number_of(text, "error"), 1e-12);
    ck_assert_double_gt(number_of(text, "projected"), 95);
    ck_assert_double_lt(number_of(text, "projected"), 100);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/smoothing_volume", sideways_keeps_the_volume);
}
