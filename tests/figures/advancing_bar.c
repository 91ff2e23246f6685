#include "figures/numbers.h"

/// The angle that is left, by the recursion of the text with half a threshold
/// to spare; the bar turns by a right angle per step.
START_TEST(steps_are_those_of_the_recursion)
{
    const double pi = 3.14159265358979323846;
    char *text = printed(&fig_advancing_bar);
    double threshold = number_of(text, "threshold"), left = pi / 3;
    int steps = 0;
    for (;;) {
        double distance = 0.5 * sin(left), time = (pi / 3 - left) / (pi / 2);
        char key[32];
        if (steps <= 3) {
            snprintf(key, sizeof key, "time_%d", steps);
            expect_number(text, key, time);
            snprintf(key, sizeof key, "distance_%d", steps);
            expect_number(text, key, distance);
        }
        if (distance <= threshold)
            break;
        left -= distance - threshold / 2;
        steps++;
    }
    expect_number(text, "steps", steps);
    expect_number(text, "time", (pi / 3 - left) / (pi / 2));
    expect_number(text, "distance", 0.5 * sin(left));
    expect_number(text, "truth", 2.0 / 3);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/advancing_bar", steps_are_those_of_the_recursion);
}
