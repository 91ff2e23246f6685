#include "figures/numbers.h"

START_TEST(areas_are_those_of_the_proposition)
{
    char *text = printed(&fig_prism_slice);
    // At half time: a quarter of the areas of both triangles, and half times
    // half of (b - a) x (c' - b'), by hand.
    expect_number(text, "area_start", 0.25 * (0.45 * 0.2 + 0.3 * 0.75) / 2);
    expect_number(text, "area_end", 0.25 * (0.6 * 0.55 + 0.05 * 0.5) / 2);
    expect_number(text, "area_between", 0.25 * (0.45 * 0.6 - 0.3 * 0.1));
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/prism_slice", areas_are_those_of_the_proposition);
}
