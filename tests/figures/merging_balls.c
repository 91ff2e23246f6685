#include "figures/numbers.h"

START_TEST(two_balls_become_one)
{
    char *text = printed(&fig_merging_balls);
    expect_number(text, "steps", 300);
    expect_number(text, "parts", 1);
    ck_assert_double_gt(number_of(text, "merge"), 1);
    ck_assert_double_lt(number_of(text, "merge"), 150);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/merging_balls", two_balls_become_one);
}
