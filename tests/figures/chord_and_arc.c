#include "figures/numbers.h"

START_TEST(errors_are_those_of_the_formulas)
{
    const double pi = 3.14159265358979323846;
    char *text = printed(&fig_chord_and_arc);
    const double turn[] = {1, 10, 30, 90};
    for (int i = 0; i < 4; i++) {
        // Half a turn on, between the middle of the chord and the arc.
        double a = turn[i] * pi / 180, x = (1 + cos(a)) / 2, y = sin(a) / 2;
        double apart = 1 - hypot(x, y);
        double change = hypot(cos(a) - 1, sin(a));
        char key[32];
        snprintf(key, sizeof key, "sagitta_%g", turn[i]);
        expect_number(text, key, apart);
        snprintf(key, sizeof key, "sagitta_percent_%g", turn[i]);
        expect_number(text, key, 100 * apart);
        snprintf(key, sizeof key, "staircase_%g", turn[i]);
        expect_number(text, key, apart + change / 4);
    }
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/chord_and_arc", errors_are_those_of_the_formulas);
}
