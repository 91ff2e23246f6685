#include "figures/numbers.h"

START_TEST(all_overlap)
{
    char *text = printed(&fig_three_fans);
    expect_number(text, "overlaps", 3);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/three_fans", all_overlap);
}
