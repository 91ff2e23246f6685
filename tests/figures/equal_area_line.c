#include "figures/numbers.h"

START_TEST(the_level_keeps_the_area)
{
    char *text = printed(&fig_equal_area_line);
    ck_assert_double_lt(fabs(number_of(text, "kept")), 1e-12);
    ck_assert_double_gt(number_of(text, "lost"), 1);
    // By as much as it is farther out.
    ck_assert_double_eq_tol(number_of(text, "gained"),
                            number_of(text, "lost") * 0.35 / 0.5, 1e-9);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/equal_area_line", the_level_keeps_the_area);
}
