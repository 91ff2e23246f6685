#include "figures/numbers.h"

START_TEST(a_bar_in_each_round)
{
    char *text = printed(&fig_failsafe_bars);
    int bars = (int)number_of(text, "bars");
    expect_number(text, "vertices", 2 * bars);
    expect_number(text, "rounds", bars - 1);
    for (int round = 0; round < bars; round++) {
        char key[32];
        snprintf(key, sizeof key, "displacement_%d", round);
        expect_number(text, key, 1.0 / (round + 1));
    }
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/failsafe_bars", a_bar_in_each_round);
}
