#include "figures/numbers.h"

START_TEST(care_keeps_the_volume)
{
    char *text = printed(&fig_enright_volume);
    expect_number(text, "steps", 300);
    expect_number(text, "triangles", 720);
    ck_assert_double_lt(number_of(text, "left"), 20);
    ck_assert_double_lt(number_of(text, "error"), 1e-3);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/enright_volume", care_keeps_the_volume);
}
