#include "figures/numbers.h"

START_TEST(both_ends_are_shown)
{
    char *text = printed(&fig_flip_motion);
    expect_number(text, "times", 4);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/flip_motion", both_ends_are_shown);
}
