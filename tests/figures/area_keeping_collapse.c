#include "figures/numbers.h"

START_TEST(the_area_is_kept)
{
    char *text = printed(&fig_area_keeping_collapse);
    ck_assert_double_gt(number_of(text, "lost"), 5);
    ck_assert_double_lt(number_of(text, "lost"), 10);
    ck_assert_double_lt(fabs(number_of(text, "error")), 1e-14);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/area_keeping_collapse", the_area_is_kept);
}
