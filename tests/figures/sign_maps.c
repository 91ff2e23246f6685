#include "figures/numbers.h"

#include <float.h>

enum {
    CELLS = 256
};

/// What the figure counts of one map.
typedef struct counts {
    int negative, zero, positive, unknown, wrong, opposite;
} counts;

static void count(counts *c, double number, double bound, int truth)
{
    int sign = (number > 0) - (number < 0);
    if (fabs(number) <= bound && bound > 0) {
        c->unknown++;
        return;
    }
    c->negative += sign < 0;
    c->zero += sign == 0;
    c->positive += sign > 0;
    c->wrong += sign != truth;
    c->opposite += sign * truth < 0;
}

static void expect_counts(const char *text, const char *map, const counts *c)
{
    static const char *const name[] = {"negative", "zero",  "positive",
                                       "unknown",  "wrong", "opposite"};
    int value[] = {c->negative, c->zero,  c->positive,
                   c->unknown,  c->wrong, c->opposite};
    for (int i = 0; i < 6; i++) {
        char key[32];
        snprintf(key, sizeof key, "%s_%s", map, name[i]);
        expect_number(text, key, value[i]);
    }
}

START_TEST(signs_are_counted)
{
    counts naive = {0}, clamped = {0}, exact = {0};
    for (int j = 0; j < CELLS; j++)
        for (int i = 0; i < CELLS; i++) {
            double x = 0.5 + i * 0x1p-53, y = 0.5 + j * 0x1p-53;
            // The line is x = y: the left of it is above.
            int truth = (j > i) - (j < i);
            double down = (12 - x) * (24 - y), up = (12 - y) * (24 - x);
            double bound =
                (3 + 0x1p-40) * DBL_EPSILON / 2 * (fabs(down) + fabs(up));
            count(&naive, down - up, 0, truth);
            count(&clamped, down - up, bound, truth);
            count(&exact, truth, 0, truth);
        }
    char *text = printed(&fig_sign_maps);
    expect_counts(text, "naive", &naive);
    expect_counts(text, "clamped", &clamped);
    expect_counts(text, "exact", &exact);
    ck_assert_int_gt(naive.opposite, 0);
    ck_assert_int_eq(clamped.wrong, 0);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/sign_maps", signs_are_counted);
}
