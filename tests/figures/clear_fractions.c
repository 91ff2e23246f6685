#include "figures/numbers.h"

/// When the point meets the edge whose right end rises by `height`.
static double time_of(double height)
{
    tf_worldline line[3] = {
        tf_worldline_between(2, (double[]){0.5, 0.2}, (double[]){0.5, 0.2}),
        tf_worldline_between(2, (double[]){1, 0}, (double[]){1, height}),
        tf_worldline_between(2, (double[]){0, 0}, (double[]){0, 0})};
    return oracle_time(2, 1, line, 2, line + 1);
}

START_TEST(half_the_step_has_a_contact)
{
    char *text = printed(&fig_clear_fractions);
    expect_number(text, "toi", time_of(1));
    ck_assert_double_gt(time_of(0.5), 0);
    expect_number(text, "half_clear", 0);
    expect_number(text, "quarter_clear", 1);
    ck_assert_double_eq(time_of(0.25), -1);
    ck_assert_double_gt(number_of(text, "early_plane"), 25);
    ck_assert_double_gt(number_of(text, "early_space"), 25);
    expect_number(text, "again_plane", 0);
    ck_assert_double_gt(number_of(text, "again_space"), 0);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/clear_fractions", half_the_step_has_a_contact);
}
