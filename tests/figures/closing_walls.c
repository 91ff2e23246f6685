#include "figures/numbers.h"

START_TEST(walls_are_held)
{
    char *text = printed(&fig_closing_walls);
    // No motion of the chain keeps the walls apart.
    ck_assert_double_gt(number_of(text, "left"), 0);
    expect_number(text, "zone_rounds", 20);
    expect_number(text, "failsafe_rounds", 2);
    expect_number(text, "held", 4);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/closing_walls", walls_are_held);
}
