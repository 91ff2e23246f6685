#include "figures/numbers.h"

static double of(const char *text, const char *failure, const char *what)
{
    char key[48];
    snprintf(key, sizeof key, "%s_%s", failure, what);
    return number_of(text, key);
}

static void expect(const char *text, const char *failure, const char *what,
                   double expected)
{
    char key[48];
    snprintf(key, sizeof key, "%s_%s", failure, what);
    expect_number(text, key, expected);
}

/// The pair meets as proposed, and not as it was pushed, to the ends expected.
static void expect_ends(const char *text, const char *failure,
                        double start[3][2], double proposed[3][2],
                        double expected[3][2])
{
    tf_worldline before[3], after[3];
    for (int v = 0; v < 3; v++) {
        double end[2];
        for (int k = 0; k < 2; k++) {
            char what[16];
            snprintf(what, sizeof what, "end_%d_%c", v, "xy"[k]);
            expect(text, failure, what, expected[v][k]);
            end[k] = of(text, failure, what);
        }
        before[v] = tf_worldline_between(2, start[v], proposed[v]);
        after[v] = tf_worldline_between(2, start[v], end);
    }
    expect(text, failure, "toi", oracle_time(2, 1, before, 2, before + 1));
    ck_assert_double_eq(oracle_time(2, 1, after, 2, after + 1), -1);
    expect(text, failure, "rounds", 1);
}

START_TEST(failures_are_as_told)
{
    const double root = sqrt(17);
    char *text = printed(&fig_row_failures);
    expect_ends(text, "seesaw", (double[3][2]){{0, 1}, {-2, 2}, {2, -2}},
                (double[3][2]){{0, 1}, {-2, -2}, {2, 2}},
                (double[3][2]){{1, 2}, {-2, -2}, {1, 1}});
    expect(text, "seesaw", "gap", sqrt(0.5));
    expect(text, "seesaw", "normal_velocity", -2 * sqrt(2));
    expect(text, "seesaw", "parting", 0);

    expect_ends(text, "turn", (double[3][2]){{1, 1}, {0, 0}, {4, 0}},
                (double[3][2]){{1, -2}, {1, 2}, {2, -2}},
                (double[3][2]){{1 + 36 / 34., -2 + 9 / 34.},
                               {1 - 36 / 34., 2 - 9 / 34.},
                               {2, -2}});
    expect(text, "turn", "toi", 5 / 9.);
    expect(text, "turn", "gap", -19 / (9 * root));
    expect(text, "turn", "normal_velocity", -9 / root);
    expect(text, "turn", "parting", root / 9);

    expect_ends(text, "slide", (double[3][2]){{0, 0}, {1, 0}, {3, 0}},
                (double[3][2]){{2, 0}, {1, 0}, {3, 0}},
                (double[3][2]){{1, 0}, {2, 0}, {3, 0}});
    expect(text, "slide", "gap", 0);
    expect(text, "slide", "normal_velocity", 0);
    expect(text, "slide", "parting", 0);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/row_failures", failures_are_as_told);
}
