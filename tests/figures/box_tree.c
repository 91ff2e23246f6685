#include "figures/numbers.h"

enum {
    EDGES = 1600
};

/// Where an edge of the curve may be: it moves on by its own length.
typedef struct swept {
    double low[2], high[2];
} swept;

static void take_in(swept *box, int vertex)
{
    double s = 2 * 3.141592653589793 * vertex / EDGES;
    double x[2] = {sin(3 * s), sin(4 * s + 0.4)};
    for (int k = 0; k < 2; k++) {
        box->low[k] = fmin(box->low[k], x[k]);
        box->high[k] = fmax(box->high[k], x[k]);
    }
}

/// How far two boxes overlap on the axis where they do so least.
static double overlap(const swept *a, const swept *b)
{
    double least = INFINITY;
    for (int k = 0; k < 2; k++)
        least =
            fmin(least, fmin(a->high[k] - b->low[k], b->high[k] - a->low[k]));
    return least;
}

START_TEST(candidates_are_those_of_all_pairs)
{
    static swept box[EDGES];
    // What overlaps by less than this may be found or not.
    const double rounding = 1e-6;
    int sure = 0, possible = 0;
    for (int i = 0; i < EDGES; i++) {
        box[i] = (swept){{2, 2}, {-2, -2}};
        for (int j = 0; j < 3; j++)
            take_in(&box[i], i + j);
        // Not the edge before, nor the last of all with the first.
        for (int j = i == EDGES - 1; j < i - 1; j++) {
            sure += overlap(&box[i], &box[j]) > rounding;
            possible += overlap(&box[i], &box[j]) > -rounding;
        }
    }
    char *text = printed(&fig_box_tree);
    ck_assert_double_ge(number_of(text, "candidates"), sure);
    ck_assert_double_le(number_of(text, "candidates"), possible);
    expect_number(text, "pairs", EDGES * (EDGES - 1) / 2);
    expect_number(text, "leaves", EDGES / 16);
    expect_number(text, "packs", 7);
    expect_number(text, "levels", 3);
    ck_assert_double_ge(number_of(text, "near"), 1);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/box_tree", candidates_are_those_of_all_pairs);
}
