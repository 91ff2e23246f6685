#include "figures/numbers.h"

START_TEST(determinant_is_that_found_by_hand)
{
    // Left in the figure of the propeller: (2, 0, 2 t), (0, 2, 0) and
    // (1, -1, 3/8 + t) have the determinant 4 (3/8 + t) - 4 t = 3/2.
    char *text = printed(&fig_coplanar_times);
    expect_number(text, "up_zeros", 0);
    expect_number(text, "up_met", 0);
    expect_number(text, "up_volume_0", 1.5);
    expect_number(text, "up_volume_1", 1.5);
    expect_number(text, "up_volume_2", 1.5);

    // Right: (-2, 0, -2 t), (0, 2, 0) and (-t, -1, 3/16 - t) have
    // -4 (3/16 - t) - 4 t t = -4 (t - 1/4) (t - 3/4).
    expect_number(text, "down_volume_0", -0.75);
    expect_number(text, "down_volume_1", 0.25);
    expect_number(text, "down_volume_2", -0.75);
    expect_number(text, "down_zeros", 2);
    expect_number(text, "down_zero_0", 0.25);
    expect_number(text, "down_zero_1", 0.75);

    // There the bar is at x = 3/4 and x = 1/4, on the propeller.
    expect_number(text, "down_met", 2);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/coplanar_times",
                    determinant_is_that_found_by_hand);
}
