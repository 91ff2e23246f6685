#include "figures/numbers.h"

START_TEST(a_speck_is_swallowed)
{
    char *text = printed(&fig_merge_around_speck);
    expect_number(text, "refused", 1);
    expect_number(text, "done", 1);
    expect_number(text, "winding_before", 0);
    expect_number(text, "winding_after", 1);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/merge_around_speck", a_speck_is_swallowed);
}
