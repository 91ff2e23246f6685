#include "figures/numbers.h"

/// How many boxes another division looks at: recursively, each cell by the
/// extremes of its corners in integers.  The scenes are multiplied by 12.
static const struct {
    const char *key;
    int corner[4][2];
} scenes[] = {
    {"pass", {{-18, -21}, {0, -9}, {0, 15}, {18, -21}}},
    {"turn", {{-18, -9}, {0, 3}, {0, 27}, {18, -9}}},
    {"slide", {{-18, -9}, {12, 6}, {-12, -6}, {18, 9}}},
};

/// The difference at (s, t) / 2^depth, times 12 * 4^depth.
static long difference(const int corner[4][2], int k, long s, long t, long one)
{
    return (one - t) * ((one - s) * corner[0][k] + s * corner[1][k]) +
           t * ((one - s) * corner[2][k] + s * corner[3][k]);
}

static bool may_hold_zero(const int corner[4][2], long s, long t, long one)
{
    for (int k = 0; k < 2; k++) {
        bool above = true, below = true;
        for (int i = 0; i < 4; i++) {
            long x = difference(corner, k, s + i % 2, t + i / 2, one);
            above = above && x > 0;
            below = below && x < 0;
        }
        if (above || below)
            return false;
    }
    return true;
}

static int count_boxes(const int corner[4][2], int depth, int most, long s,
                       long t)
{
    if (depth > 0 && !may_hold_zero(corner, s, t, 1L << depth))
        return 1;
    int count = 1;
    for (int i = 0; depth < most && i < 4; i++)
        count +=
            count_boxes(corner, depth + 1, most, 2 * s + i % 2, 2 * t + i / 2);
    return count;
}

START_TEST(boxes_are_as_many)
{
    char *text = printed(&fig_inclusion_boxes);
    for (int i = 0; i < 3; i++)
        for (int depth = 1; depth <= 14; depth++) {
            char key[32];
            snprintf(key, sizeof key, "%s_%d", scenes[i].key, depth);
            expect_number(text, key,
                          count_boxes(scenes[i].corner, 0, depth, 0, 0));
        }
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/inclusion_boxes", boxes_are_as_many);
}
