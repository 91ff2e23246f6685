#include "figures/numbers.h"

// The triangle of the figure: a, b and c in the plane at t = 0 and t = 1.
static const fig_point start[3] = {{0, 0.35}, {0.4, 0}, {0.7, 0.5}};
static const fig_point end[3] = {{0.05, 0.25}, {0.5, 0.05}, {0.65, 0.6}};

/// Twice the area of a polygon, by Gauss's formula.
static double twice_area(int count, const fig_point corner[])
{
    double sum = 0;
    for (int i = 0; i < count; i++) {
        fig_point p = corner[i], q = corner[(i + 1) % count];
        sum += p.x * q.y - p.y * q.x;
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
    fig_point middle[6];
    for (int i = 0; i < 6; i++)
        middle[i] = (fig_point){(start[from[i]].x + end[to[i]].x) / 2,
                                (start[from[i]].y + end[to[i]].y) / 2};
    return (twice_area(3, start) + 4 * twice_area(6, middle) +
            twice_area(3, end)) /
           12;
}

START_TEST(volumes_are_right)
{
    char *text = printed(&fig_prism);
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
