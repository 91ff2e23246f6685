#include "figures/numbers.h"

static const double down = 1, up = 1.5, length = 6;

/// How many triangles of the edge's sweep hold a point at rest, by the oracle.
static int passes_at(double x, double y)
{
    tf_worldline point =
        tf_worldline_between(2, (double[]){x, y}, (double[]){x, y});
    tf_worldline edge[2] = {
        tf_worldline_between(2, (double[]){0, 0}, (double[]){0, -down}),
        tf_worldline_between(2, (double[]){length, 0}, (double[]){length, up})};
    oracle_simplex path = oracle_step(1, &point, 0);
    int passes = 0;
    for (int pivot = 0; pivot < 2; pivot++) {
        oracle_simplex step = oracle_step(2, edge, pivot);
        mpq_t toi;
        mpq_init(toi);
        passes += oracle_simplices_meet(2, &path, &step, toi);
        mpq_clear(toi);
    }
    return passes;
}

START_TEST(areas_are_those_of_a_grid)
{
    enum {
        COLUMNS = 60,
        ROWS = 50
    };
    // The places of a grid that the staircase passes at all, and twice.
    int all = 0, twice = 0;
    for (int i = 0; i < COLUMNS * ROWS; i++) {
        int row = i / COLUMNS;
        double x = (i % COLUMNS + 0.5) * length / COLUMNS;
        double y = (row + 0.5) * (down + up) / ROWS - down;
        int passes = passes_at(x, y);
        all += passes > 0;
        twice += passes > 1;
    }
    double cell = (down + up) / ROWS * 2 / COLUMNS;
    char *text = printed(&fig_swept_twice);
    ck_assert_double_eq_tol(number_of(text, "all"), all * cell, 0.02);
    ck_assert_double_eq_tol(number_of(text, "twice"), twice * cell, 0.02);
    expect_number(text, "passes_between", passes_at(2.5, 0.5));
    expect_number(text, "passes_beyond", passes_at(5, 0.25));
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/swept_twice", areas_are_those_of_a_grid);
}
