#include "figures/numbers.h"

/// The number of steps by the recursion of the text, and the time that is left
/// of the step's right angle.
static int count_steps(double radius, double threshold, double *error)
{
    const double pi = 3.14159265358979323846;
    double left = pi / 3;
    int steps = 0;
    for (; radius * sin(left) > threshold; steps++)
        left -= radius * sin(left) - threshold / 2;
    *error = left / (pi / 2);
    return steps;
}

START_TEST(steps_and_errors_are_those_of_the_recursion)
{
    char *text = printed(&fig_advancement_steps);
    const double radius[] = {0.1, 0.5, 0.9};
    for (int r = 0; r < 3; r++)
        for (int i = 2; i <= 12; i++) {
            double error, threshold = pow(10, -i);
            int steps = count_steps(radius[r], threshold, &error);
            char key[32];
            snprintf(key, sizeof key, "steps_%g_%d", radius[r], i);
            expect_number(text, key, steps);
            snprintf(key, sizeof key, "error_%g_%d", radius[r], i);
            double found = number_of(text, key);
            ck_assert_msg(found > 0 && fabs(found - error) <= 1e-3 * error,
                          "%s is %g, not %g", key, found, error);
        }
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/advancement_steps",
                    steps_and_errors_are_those_of_the_recursion);
}
