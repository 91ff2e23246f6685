#include "figures/numbers.h"

/// The angle in degrees between two directions.
static double angle(const double u[3], const double v[3])
{
    double uv = 0, uu = 0, vv = 0;
    for (int k = 0; k < 3; k++) {
        uv += u[k] * v[k];
        uu += u[k] * u[k];
        vv += v[k] * v[k];
    }
    return acos(uv / sqrt(uu * vv)) * 180 / acos(-1);
}

/// Expect a bend between t = 0 and t = 1, and none at the ends.
static void expect_bend(const char *text, const char *name, double bend)
{
    for (int quarter = 0; quarter <= 4; quarter++) {
        char key[40];
        snprintf(key, sizeof key, "%s_%g", name, quarter / 4.0);
        expect_number(text, key, quarter % 4 == 0 ? 0 : bend);
    }
}

START_TEST(bends_are_those_of_the_ends)
{
    char *text = printed(&fig_bent_slices);
    expect_bend(text, "edge_bend",
                angle((double[]){4, 0, 0}, (double[]){4, 1, 0}));
    // (b - a) x (c - a), (b - a) x (c' - b') and (b' - a') x (c' - a'), by hand
    double start[3] = {0, 0, 1.02}, mixed[3] = {0.04, 0.48, 0.91},
           end[3] = {0.52, 0.79, 0.93};
    expect_bend(text, "triangle_bend", angle(start, mixed));
    expect_bend(text, "triangle_bend_second", angle(mixed, end));
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/bent_slices", bends_are_those_of_the_ends);
}
