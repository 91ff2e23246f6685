#include "figures/numbers.h"

/// The points start at (1 + shift, 3) and the edge's line is y = t + t x / 4.
static double root(double shift)
{
    // 12 - (17 + shift) t - t^2
    double b = 17 + shift;
    return (sqrt(b * b + 48) - b) / 2;
}

/// The point past the edge's end at a time, from that end.
static double distance(double shift, double t)
{
    double x = 1 + shift + t - 4, y = 3 - 3 * t - 2 * t;
    return hypot(x, y);
}

START_TEST(roots_and_distances)
{
    char *text = printed(&fig_root_and_window);
    double shift = number_of(text, "shift"), t = root(shift);
    double tolerance = number_of(text, "tolerance");
    expect_number(text, "shift", 2.75);
    expect_number(text, "hit_root", root(0));
    expect_number(text, "miss_root", t);
    expect_number(text, "hit_distance", 0);
    expect_number(text, "miss_distance", distance(shift, t));
    ck_assert(1 + shift + t > 4);
    expect_number(text, "hit_exact", 1);
    expect_number(text, "miss_exact", 0);
    expect_number(text, "hit_tolerant", 1);
    expect_number(text, "miss_tolerant", 1);
    ck_assert(distance(shift, t) < tolerance);

    // At the ends of the window the distance is the tolerance.
    double from = number_of(text, "miss_from"), to = number_of(text, "miss_to");
    ck_assert(from < t && t < to);
    ck_assert_double_eq_tol(distance(shift, to), tolerance, 1e-12);
    ck_assert_double_eq_tol(distance(shift, from), tolerance, 1e-12);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/root_and_window", roots_and_distances);
}
