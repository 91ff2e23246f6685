#include "figures/numbers.h"

// The triangle of the figure: a, b and c in the plane at t = 0 and t = 1.
static const double start[3][2] = {{0, 0.35}, {0.4, 0}, {0.7, 0.5}};
static const double end[3][2] = {{0.05, 0.25}, {0.5, 0.05}, {0.65, 0.6}};

/// Twice the area of a polygon, by Gauss's formula.
static double twice_area(int count, const double corner[][2])
{
    double sum = 0;
    for (int i = 0; i < count; i++) {
        const double *p = corner[i], *q = corner[(i + 1) % count];
        sum += p[0] * q[1] - p[1] * q[0];
    }
    return sum;
}

/// The volume of the prism: its slices grow by a quadratic law, for which
/// Simpson's rule is exact.
static double whole_volume(void)
{
    // Between the midpoints of the ways of the vertices the walls are bent: at
    // the midpoint of the event at t = 0 of the first and the one at t = 1 of
    // the second.
    static const int from[6] = {0, 0, 1, 1, 2, 0}, to[6] = {0, 1, 1, 2, 2, 2};
    double middle[6][2];
    for (int i = 0; i < 6; i++)
        for (int k = 0; k < 2; k++)
            middle[i][k] = (start[from[i]][k] + end[to[i]][k]) / 2;
    return (twice_area(3, start) +
            4 * twice_area(6, (const double(*)[2])middle) +
            twice_area(3, end)) /
           12;
}

START_TEST(volumes_are_right)
{
    char *text = printed(&tf_figure_prism);
    // (b - a) x (c - a), (b - a) x (c' - b') and (b' - a') x (c' - a'), by hand
    expect_number(text, "volume_abcc", 0.305 / 6);
    expect_number(text, "volume_abbc", 0.2725 / 6);
    expect_number(text, "volume_aabc", 0.2775 / 6);
    expect_number(text, "volume", whole_volume());
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/prism", volumes_are_right);
}
