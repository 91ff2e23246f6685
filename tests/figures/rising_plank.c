#include "figures/numbers.h"

/// When the fly and the plank meet, as their displacements are printed.
static double meeting(const char *text, const char *state)
{
    const double start[3][2] = {{0, 0.125}, {-2, 0}, {2, 0}};
    tf_worldline vertex[3];
    for (int v = 0; v < 3; v++) {
        char key[32];
        snprintf(key, sizeof key, "move_%d_%s", v, state);
        double end[2] = {start[v][0], start[v][1] + number_of(text, key)};
        vertex[v] = tf_worldline_between(2, start[v], end);
    }
    return oracle_time(2, 1, vertex, 2, vertex + 1);
}

START_TEST(only_one_push_is_enough)
{
    char *text = printed(&fig_rising_plank);
    expect_number(text, "toi_proposed", meeting(text, "proposed"));
    expect_number(text, "toi_gradient", meeting(text, "gradient"));
    expect_number(text, "toi_coordinates", meeting(text, "coordinates"));
    expect_number(text, "toi_proposed", 0.125);
    expect_number(text, "toi_gradient", 0.75);
    expect_number(text, "toi_coordinates", -1);
    expect_number(text, "move_0_gradient", 0.5);
    expect_number(text, "move_1_gradient", 1);
    expect_number(text, "move_2_gradient", 0.5);
    for (int v = 0; v < 3; v++) {
        char key[32];
        snprintf(key, sizeof key, "move_%d_coordinates", v);
        expect_number(text, key, 2 / 3.);
    }

    // The second push, by hand: the shares are 3/4, 1/4 and 1/2, and the piece
    // that hits has the direction (4, -1/2).
    double parting = 0.75 * 0.5 - 0.25 * 1 - 0.5 * 0.5;
    double compliance = 0.75 * 0.75 + 0.25 * 0.25 + 0.5 * 0.5;
    double push = -parting / compliance * 16 / 16.25;
    expect_number(text, "rounds_gradient", 2);
    expect_number(text, "left_end", 1 - 0.25 * push);
    expect_number(text, "right_end", 0.5 - 0.5 * push);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/rising_plank", only_one_push_is_enough);
}
