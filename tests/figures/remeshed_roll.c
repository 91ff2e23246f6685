#include "figures/numbers.h"

START_TEST(only_exact_tests_keep_it_clear)
{
    char *text = printed(&fig_remeshed_roll);
    expect_number(text, "clear_crossings", 0);
    ck_assert_double_gt(number_of(text, "crossings"), 100);
    ck_assert_double_gt(number_of(text, "refused"),
                        0.2 * number_of(text, "tried"));
    ck_assert_double_lt(number_of(text, "triangles"),
                        number_of(text, "triangles_before") / 4);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/remeshed_roll", only_exact_tests_keep_it_clear);
}
