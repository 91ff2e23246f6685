#include "figures/numbers.h"

START_TEST(the_objective_falls)
{
    char *text = printed(&fig_local_global_step);
    double before = number_of(text, "before");
    double after_one = number_of(text, "after_one");
    double after_all = number_of(text, "after_all");
    ck_assert_double_lt(after_one, before / 2);
    ck_assert_double_lt(after_all, after_one);
    ck_assert_double_gt(after_all, 0);
    ck_assert_double_ge(number_of(text, "change_at_last"), 0);
    expect_number(text, "iterations", 10);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/local_global_step", the_objective_falls);
}
