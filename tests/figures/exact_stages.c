#include "figures/numbers.h"

#include <float.h>
#include <gmp.h>

enum {
    CELLS = 96
};

static double from_half(int i)
{
    return i < 0 ? 0.5 + ldexp(i, -54) : 0.5 + ldexp(i, -53);
}

/// Whether to - from is rounded.
static bool is_rounded(double to, double from)
{
    mpq_t exact, other;
    mpq_inits(exact, other, NULL);
    mpq_set_d(exact, to);
    mpq_set_d(other, from);
    mpq_sub(exact, exact, other);
    mpq_set_d(other, to - from);
    bool rounded = !mpq_equal(exact, other);
    mpq_clears(exact, other, NULL);
    return rounded;
}

START_TEST(stages_are_counted)
{
    int estimate = 0, wholes = 0, tails = 0;
    for (int j = -CELLS / 2; j < CELLS / 2; j++)
        for (int i = -CELLS / 2; i < CELLS / 2; i++) {
            double x = from_half(i), y = from_half(j);
            double down = (1.125 - x) * (1.375 - y);
            double up = (1.125 - y) * (1.375 - x);
            double bound = (3 + 0x1p-40) * DBL_EPSILON / 2 * (down + up);
            bool rounded = is_rounded(1.125, x) || is_rounded(1.125, y) ||
                           is_rounded(1.375, x) || is_rounded(1.375, y);
            estimate += fabs(down - up) > bound;
            wholes += fabs(down - up) <= bound && !rounded;
            tails += fabs(down - up) <= bound && rounded;
        }
    char *text = printed(&fig_exact_stages);
    expect_number(text, "estimate", estimate);
    expect_number(text, "wholes", wholes);
    expect_number(text, "tails", tails);
    expect_number(text, "open", wholes + tails);
    ck_assert_int_gt(wholes, 0);
    ck_assert_int_gt(tails, 0);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/exact_stages", stages_are_counted);
}
