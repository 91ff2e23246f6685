#include "figures/numbers.h"

// The normals are (0, 1) and (sqrt(3), 1) / 2, and the proposal is (-1, -1/10).
START_TEST(impulses_are_right)
{
    char *text = printed(&fig_bead_in_corner);
    double lack[2] = {0.1, sqrt(3) / 2 + 0.05}, both = 0.5;
    expect_number(text, "glued_0",
                  (lack[0] - both * lack[1]) / (1 - both * both));
    expect_number(text, "glued_1",
                  (lack[1] - both * lack[0]) / (1 - both * both));
    expect_number(text, "nearest_0", 0);
    expect_number(text, "nearest_1", lack[1]);
    expect_number(text, "first_push", lack[0]);
    ck_assert_double_gt(both * lack[1], lack[0]); // the bead leaves the floor
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/bead_in_corner", impulses_are_right);
}
