#include "figures/numbers.h"

START_TEST(a_tip_turned_inside_out_is_refused)
{
    char *text = printed(&fig_pinched_tip);
    expect_number(text, "refused", 1);
    expect_number(text, "fine", 1);
    ck_assert_double_lt(number_of(text, "volume"), 0);
    ck_assert_double_gt(number_of(text, "volume_fine"), 0);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/pinched_tip", a_tip_turned_inside_out_is_refused);
}
