#include "figures/numbers.h"

START_TEST(distances_are_right)
{
    const double u = 0.3, v = 0.42, p[2] = {-0.35, -0.25};
    const double angle = acos(-1) * 7 / 180, s = sin(angle), c = cos(angle);
    double lack[2] = {u - p[1], v - s * p[0] - c * p[1]};
    char *text = printed(&fig_nearly_parallel_rows);
    expect_number(text, "angle", 7);

    // The second row is the farther one, and to satisfy it satisfies the first.
    ck_assert_double_gt(p[1] + lack[1] * c, u);
    expect_number(text, "nearest", lack[1]);

    double crossing[2] = {(v - c * u) / s, u};
    ck_assert_double_eq_tol(number_of(text, "second"),
                            hypot(crossing[0] - p[0], crossing[1] - p[1]),
                            1e-6);

    // One iteration of conjugate residuals: along b, to the least residual.
    double image[2] = {lack[0] + c * lack[1], c * lack[0] + lack[1]};
    double step = (lack[0] * image[0] + lack[1] * image[1]) /
                  (image[0] * image[0] + image[1] * image[1]);
    ck_assert_double_eq_tol(number_of(text, "first"),
                            step * hypot(s * lack[1], lack[0] + c * lack[1]),
                            1e-9);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/nearly_parallel_rows", distances_are_right);
}
