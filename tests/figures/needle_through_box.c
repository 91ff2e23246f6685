#include "figures/numbers.h"
#include "support/moved_simplices.h"

/// The triangles of a box, its corner i at the bits of i: all diagonals start
/// at corner 0 or 7.
static const int facet[12][3] = {
    {0, 1, 3}, {0, 2, 3}, {0, 1, 5}, {0, 4, 5}, {0, 2, 6}, {0, 4, 6},
    {7, 6, 4}, {7, 5, 4}, {7, 6, 2}, {7, 3, 2}, {7, 5, 1}, {7, 3, 1},
};

/// Needles through the same triangles as the figure's, but in eighths.
static const struct {
    const char *key;
    int end[2][3];
} needles[] = {
    {"inside", {{2, 6, -4}, {6, 2, 12}}},
    {"diagonal", {{4, 4, -4}, {4, 4, 12}}},
    {"corner", {{-2, -2, -2}, {10, 10, 10}}},
};

START_TEST(needles_meet_as_many_triangles)
{
    char *text = printed(&fig_needle_through_box);
    for (int n = 0; n < 3; n++) {
        tf_event corner[8], end[2];
        for (int i = 0; i < 8; i++)
            corner[i] =
                (tf_event){.x = {(i & 1) * 8, (i >> 1 & 1) * 8, (i >> 2) * 8},
                           .vertex = i};
        for (int i = 0; i < 2; i++) {
            const int *x = needles[n].end[i];
            end[i] = (tf_event){.x = {x[0], x[1], x[2]}, .vertex = 8 + i};
        }
        int exact = 0, perturbed = 0;
        for (int i = 0; i < 12; i++) {
            const int *f = facet[i];
            moved_pair pair = {
                .axes = 3,
                .s = {2, {&end[0], &end[1]}},
                .r = {3, {&corner[f[0]], &corner[f[1]], &corner[f[2]]}}};
            exact += oracle_slices_meet(3, &pair.s, &pair.r);
            perturbed += moved_pair_meets_by_oracle(&pair, 24, NULL);
        }
        char key[32];
        snprintf(key, sizeof key, "exact_%s", needles[n].key);
        expect_number(text, key, exact);
        snprintf(key, sizeof key, "perturbed_%s", needles[n].key);
        expect_number(text, key, perturbed);
    }
    // By hand: six triangles at either corner.
    expect_number(text, "exact_corner", 12);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/needle_through_box",
                    needles_meet_as_many_triangles);
}
