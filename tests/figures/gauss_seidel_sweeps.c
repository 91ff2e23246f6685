#include "figures/numbers.h"

// That the energy never rises, the figure itself requires.
START_TEST(pushes_are_taken_back)
{
    char *text = printed(&fig_gauss_seidel_sweeps);
    expect_number(text, "shown", 40);
    expect_number(text, "film_still", 40.0 / 48);
    ck_assert_double_ge(number_of(text, "taken_back"), 1);
    double left = number_of(text, "left");
    ck_assert(left > 0 && left < 0.2);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/gauss_seidel_sweeps", pushes_are_taken_back);
}
