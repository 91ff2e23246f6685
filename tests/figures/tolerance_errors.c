#include "figures/rows.h"

/// The least of a count over all tolerances, or of the sum of two.
static double least_of(const char *set, const char *first, const char *second)
{
    double least = INFINITY;
    for (int digits = 0; digits <= 16; digits++) {
        char row[80], tolerance[8] = "0";
        if (digits > 0)
            snprintf(tolerance, sizeof tolerance, "1e-%02d", digits);
        snprintf(row, sizeof row, "cubic %s %s %s", tolerance, set, first);
        double count = methods_value(row);
        if (second) {
            snprintf(row, sizeof row, "cubic %s %s %s", tolerance, set, second);
            count += methods_value(row);
        }
        least = fmin(least, count);
    }
    return least;
}

START_TEST(errors_are_those_counted)
{
    static const char *const sets[] = {"adversarial", "public", "random"};
    char *text = printed(&fig_tolerance_errors);
    for (int s = 0; s < 3; s++) {
        char key[64];
        snprintf(key, sizeof key, "%s_least", sets[s]);
        expect_number(text, key, least_of(sets[s], "missed", "extra"));
        snprintf(key, sizeof key, "%s_missed_least", sets[s]);
        expect_number(text, key, least_of(sets[s], "missed", NULL));
        snprintf(key, sizeof key, "%s_extra_least", sets[s]);
        expect_number(text, key, least_of(sets[s], "extra", NULL));
    }
    // The claim of the chapter: on hard queries both are never zero.
    ck_assert(number_of(text, "adversarial_missed_least") > 0);
    ck_assert(number_of(text, "adversarial_extra_least") > 0);
    ck_assert(number_of(text, "public_least") > 0);
    expect_number(text, "random_least", 0);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/tolerance_errors", errors_are_those_counted);
}
