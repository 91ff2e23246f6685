#include "figures/numbers.h"

#include "support/oracle.h"

/// An encounter as it is and as a person would judge it.
typedef struct expected {
    const char *key;
    double start[3][2], end[3][2]; ///< p, a, b
    bool degenerate, touching;
} expected;

static const expected encounters[] = {
    {"parallel",
     {{0.75, 0.25}, {0, 0.25}, {0.5, 0.25}},
     {{1, 0.875}, {0.25, 0.875}, {0.75, 0.875}},
     false,
     false},
    {"point_like",
     {{0, 0.375}, {0.875, 0.875}, {0.875, 0.875}},
     {{1, 0.625}, {0.125, 0.125}, {0.125, 0.125}},
     true,
     false},
    {"within_plane",
     {{0, 0.125}, {0.25, 0.3125}, {0.75, 0.6875}},
     {{1, 0.875}, {0.25, 0.3125}, {0.75, 0.6875}},
     true,
     false},
    {"vertex",
     {{0, 0.25}, {1, 0.25}, {0.5, 0}},
     {{1, 0.75}, {0.875, 0.875}, {0.5, 1}},
     false,
     true},
};

static double number_under(const char *text, const expected *e,
                           const char *what)
{
    char key[64];
    snprintf(key, sizeof key, "%s_%s", e->key, what);
    return number_of(text, key);
}

static void expect_encounter(const char *text, const expected *e)
{
    tf_worldline vertex[3];
    for (int i = 0; i < 3; i++)
        vertex[i] = tf_worldline_between(2, e->start[i], e->end[i]);
    mpq_t toi;
    mpq_init(toi);
    bool hit = oracle_meet(2, 1, &vertex[0], 2, vertex + 1, toi);
    double time = mpq_get_d(toi);
    mpq_clear(toi);
    ck_assert_msg(number_under(text, e, "hit") == hit, "%s: hit", e->key);
    if (!hit)
        return;
    ck_assert_double_eq_tol(number_under(text, e, "time"), time, 1e-15);
    ck_assert_msg(number_under(text, e, "degenerate") == e->degenerate,
                  "%s: degenerate", e->key);
    ck_assert_msg(number_under(text, e, "touching") == e->touching,
                  "%s: touching", e->key);
}

START_TEST(verdicts_and_times_are_the_oracles)
{
    char *text = printed(&fig_degenerate_point_edge);
    for (size_t i = 0; i < sizeof encounters / sizeof encounters[0]; i++)
        expect_encounter(text, &encounters[i]);
    ck_assert_double_eq(number_of(text, "parallel_hit"), 0);
    expect_number(text, "within_plane_time", 0.25);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/degenerate_point_edge",
                    verdicts_and_times_are_the_oracles);
}
