#include "figures/numbers.h"

START_TEST(needles_are_gone)
{
    char *text = printed(&fig_remeshed_plate);
    expect_number(text, "rounds", 5);
    expect_number(text, "triangles_before", 208);
    ck_assert_double_lt(number_of(text, "angle_before"), 2);
    ck_assert_double_gt(number_of(text, "triangles_after"), 1500);
    ck_assert_double_gt(number_of(text, "angle_after"), 20);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/remeshed_plate", needles_are_gone);
}
