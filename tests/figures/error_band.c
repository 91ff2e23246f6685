#include "figures/numbers.h"

#include <float.h>

enum {
    ROW = 192,
    CELLS = 256
};

START_TEST(error_stays_in_the_band)
{
    double u = DBL_EPSILON / 2, y = 0.5 + ROW * u, worst = 0, step = INFINITY;
    for (int i = 0; i < CELLS; i++) {
        double x = 0.5 + i * u;
        double number = (12 - x) * (24 - y) - (12 - y) * (24 - x);
        worst = fmax(worst, fabs(number / u - 12 * (ROW - i)));
        if (number != 0)
            step = fmin(step, fabs(number / u));
    }
    char *text = printed(&fig_error_band);
    expect_number(text, "error", worst);
    expect_number(text, "step", step);
    // At the diagonal both products are about 11.5 23.5.
    ck_assert_double_eq_tol(number_of(text, "bound"), 3 * 2 * 11.5 * 23.5, 1);
    ck_assert_double_lt(worst, number_of(text, "bound"));
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/error_band", error_stays_in_the_band);
}
