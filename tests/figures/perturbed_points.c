#include "figures/numbers.h"

enum {
    AXES = 2
};

/// (b - a) x (c - a) in rational numbers.
static int turn_of(double x[3][AXES])
{
    mpq_t entry[2][AXES], origin, product[2];
    mpq_inits(origin, product[0], product[1], NULL);
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < AXES; k++) {
            mpq_init(entry[i][k]);
            mpq_set_d(entry[i][k], x[i + 1][k]);
            mpq_set_d(origin, x[0][k]);
            mpq_sub(entry[i][k], entry[i][k], origin);
        }
    mpq_mul(product[0], entry[0][0], entry[1][1]);
    mpq_mul(product[1], entry[0][1], entry[1][0]);
    int turn = mpq_cmp(product[0], product[1]);
    for (int i = 0; i < 2; i++)
        mpq_clears(entry[i][0], entry[i][1], product[i], NULL);
    mpq_clear(origin);
    return (turn > 0) - (turn < 0);
}

/// The symbols may be any numbers that shrink so fast: a moves by the first
/// two, b and c by these divided by `ratio` once and twice.
START_TEST(moved_points_turn_as_printed)
{
    char *text = printed(&fig_perturbed_points);
    const double first[AXES] = {number_of(text, "first"),
                                number_of(text, "second")};
    ck_assert(first[0] > first[1] && first[1] > 0);
    for (double ratio = 16; ratio < 0x1p40; ratio *= 2) {
        double x[3][AXES];
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < AXES; k++)
                x[i][k] = (k == 0 ? i : 0) + first[k] / pow(ratio, i);
        expect_number(text, "turn", turn_of(x));
    }
    // By hand: the points themselves are in a row.
    ck_assert_int_eq(turn_of((double[3][AXES]){{0, 0}, {1, 0}, {2, 0}}), 0);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/perturbed_points", moved_points_turn_as_printed);
}
