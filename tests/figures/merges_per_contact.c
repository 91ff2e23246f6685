#include "figures/numbers.h"

START_TEST(greed_makes_handles)
{
    char *text = printed(&fig_merges_per_contact);
    ck_assert_double_gt(number_of(text, "greedy"), 5);
    // The first merge joins the balls, and each other one makes a handle.
    expect_number(text, "genus", number_of(text, "greedy") - 1);
    expect_number(text, "once", 1);
    expect_number(text, "once_genus", 0);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/merges_per_contact", greed_makes_handles);
}
