#include "figures/numbers.h"

START_TEST(only_overlaps_are_refused_and_only_if_it_is_narrow)
{
    char *text = printed(&fig_refused_operations);
    ck_assert_double_gt(number_of(text, "narrow"), 50);
    expect_number(text, "wide", 0);
    expect_number(text, "others", 0);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/refused_operations",
                    only_overlaps_are_refused_and_only_if_it_is_narrow);
}
