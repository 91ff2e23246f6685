#include "figures/numbers.h"

START_TEST(all_overlap)
{
    char *text = printed(&fig_overlapping_fans);
    expect_number(text, "overlaps", 3);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/overlapping_fans", all_overlap);
}
