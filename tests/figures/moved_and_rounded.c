#include "figures/numbers.h"

START_TEST(far_moves_are_the_worst)
{
    char *text = printed(&fig_moved_and_rounded);
    // "More than a third."
    ck_assert_double_gt(number_of(text, "far_15"), 100.0 / 3);
    expect_number(text, "far_13", 0);
    expect_number(text, "near_15", 0);
    expect_number(text, "turned_15", 0);
    ck_assert_double_gt(number_of(text, "near_17"), 0);
    ck_assert_double_gt(number_of(text, "turned_17"), 0);
    // Three vertices: as many rounds as the theorem allows.
    expect_number(text, "most_rounds", 2);
    ck_assert_double_gt(number_of(text, "frozen"), 0);
    ck_assert_double_le(number_of(text, "frozen"), number_of(text, "touching"));
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/moved_and_rounded", far_moves_are_the_worst);
}
