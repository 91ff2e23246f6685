#include "figures/numbers.h"

#include "support/queries.h"

enum {
    SAMPLES = 2000
};

/// The distance from `p` to the closest of some points.
static double distance_to(const double p[2], double set[SAMPLES + 1][2])
{
    double least = INFINITY;
    for (int i = 0; i <= SAMPLES; i++)
        least = fmin(least, hypot(set[i][0] - p[0], set[i][1] - p[1]));
    return least;
}

/// The largest distance from a point of `from` to the closest of `to`.
static double farthest(double from[SAMPLES + 1][2], double to[SAMPLES + 1][2])
{
    double most = 0;
    for (int i = 0; i <= SAMPLES; i++)
        most = fmax(most, distance_to(from[i], to));
    return most;
}

START_TEST(distances_are_right)
{
    const tf_worldline edge[2] = {
        tf_worldline_between(2, (double[]){0.1, 0.75}, (double[]){0.3, 0.05}),
        tf_worldline_between(2, (double[]){1.25, 0.15},
                             (double[]){1.05, 0.95})};
    static double bent[SAMPLES + 1][2], straight[SAMPLES + 1][2];
    double shift = 0;
    for (int i = 0; i <= SAMPLES; i++) {
        double s = (double)i / SAMPLES;
        staircase_point(2, 2, edge, (double[]){1 - s, s}, 0.5, bent[i]);
        for (int k = 0; k < 2; k++)
            straight[i][k] =
                ((1 - s) * (edge[0].at[0].x[k] + edge[0].at[1].x[k]) +
                 s * (edge[1].at[0].x[k] + edge[1].at[1].x[k])) /
                2;
        shift = fmax(shift, hypot(bent[i][0] - straight[i][0],
                                  bent[i][1] - straight[i][1]));
    }
    char *text = printed(&fig_staircase_patch);
    expect_number(text, "gap", 0.37125 / sqrt(0.925)); // by hand
    expect_number(text, "shift", sqrt(0.150625));
    ck_assert_double_eq_tol(number_of(text, "shift"), shift, 1e-12);
    double gap = fmax(farthest(bent, straight), farthest(straight, bent));
    ck_assert_double_eq_tol(number_of(text, "gap"), gap, 1e-5);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/staircase_patch", distances_are_right);
}
