#include "figures/numbers.h"

#include "support/queries.h"

/// How far a painted point of the plank moves in a time.
static void move_of(const tf_worldline plank[2], const double weight[2],
                    double t, double later, double move[2])
{
    double place[2];
    staircase_point(2, 2, plank, weight, t, place);
    staircase_point(2, 2, plank, weight, later, move);
    for (int k = 0; k < 2; k++)
        move[k] -= place[k];
}

START_TEST(plank_kicks_the_fly)
{
    const double fly[2] = {0, 1};
    tf_worldline still = tf_worldline_between(2, fly, fly);
    tf_worldline plank[2] = {
        tf_worldline_between(2, (double[]){-2, 2}, (double[]){-2, -2}),
        tf_worldline_between(2, (double[]){2, -2}, (double[]){2, 2})};
    double t = oracle_time(2, 1, &still, 2, plank), at[2], move[2];
    char *text = printed(&fig_turning_plank);
    expect_number(text, "toi", t);
    expect_number(text, "barycentric_0", 0.5);
    expect_number(text, "barycentric_1", 0.5);
    staircase_point(2, 2, plank, (double[]){0.5, 0.5}, t, at);
    for (int k = 0; k < 2; k++)
        ck_assert_double_eq(at[k], fly[k]);

    // The fly, at rest, is seen from the painted point that it meets.
    move_of(plank, (double[]){0.5, 0.5}, t, t + 0.125, move);
    double velocity[2] = {-move[0] / 0.125, -move[1] / 0.125};
    expect_number(text, "velocity_x", velocity[0]);
    expect_number(text, "velocity_y", velocity[1]);

    // By hand: the piece goes from (-1, 2) to (2, -1).
    const double half = sqrt(0.5);
    expect_number(text, "normal_x", half);
    expect_number(text, "normal_y", half);
    expect_number(text, "normal_velocity", half * (velocity[0] + velocity[1]));
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/turning_plank", plank_kicks_the_fly);
}
