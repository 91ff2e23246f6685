#include "figures/numbers.h"

START_TEST(the_area_is_kept)
{
    char *text = printed(&fig_kept_volume);
    ck_assert_double_gt(number_of(text, "lost"), 5);
    ck_assert_double_lt(number_of(text, "lost"), 10);
    ck_assert_double_lt(fabs(number_of(text, "error")), 1e-14);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/kept_volume", the_area_is_kept);
}
