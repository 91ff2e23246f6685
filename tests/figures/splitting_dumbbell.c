#include "figures/numbers.h"

START_TEST(a_dumbbell_comes_apart)
{
    char *text = printed(&fig_splitting_dumbbell);
    expect_number(text, "steps", 150);
    ck_assert_double_gt(number_of(text, "pinch"), 1);
    ck_assert_double_gt(number_of(text, "parts"), 1);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/splitting_dumbbell", a_dumbbell_comes_apart);
}
