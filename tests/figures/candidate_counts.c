#include "figures/numbers.h"

#include "kit/random.h"

enum {
    TRIANGLES = 64,
    SIZES = 13
};

static double x[TRIANGLES][3][3];

static void place(double size)
{
    uint64_t random = 13;
    for (int i = 0; i < TRIANGLES; i++)
        for (int k = 0; k < 3; k++) {
            double low = (1 - size) * fig_random_number(&random);
            for (int c = 0; c < 3; c++)
                x[i][c][k] = low + size * fig_random_number(&random);
        }
}

/// Whether the boxes around some corners of two triangles overlap; corners are
/// a bit each.
static bool overlap(int i, int corners, int j, int others)
{
    for (int k = 0; k < 3; k++) {
        double low[2] = {2, 2}, high[2] = {-2, -2};
        for (int c = 0; c < 3; c++) {
            if (corners >> c & 1)
                low[0] = fmin(low[0], x[i][c][k]),
                high[0] = fmax(high[0], x[i][c][k]);
            if (others >> c & 1)
                low[1] = fmin(low[1], x[j][c][k]),
                high[1] = fmax(high[1], x[j][c][k]);
        }
        if (low[0] > high[1] || low[1] > high[0])
            return false;
    }
    return true;
}

/// Points of each against the other, and the edges of both.
static int candidates(int i, int j)
{
    static const int edges[] = {3, 5, 6};
    int count = 0;
    for (int c = 0; c < 3; c++) {
        count += overlap(i, 1 << c, j, 7) + overlap(i, 7, j, 1 << c);
        for (int d = 0; d < 3; d++)
            count += overlap(i, edges[c], j, edges[d]);
    }
    return count;
}

START_TEST(candidates_are_those_of_all_pairs)
{
    char *text = printed(&fig_candidate_counts), key[32];
    for (int size = 0; size < SIZES; size++) {
        int count = 0;
        place(pow(10, -1.5 + 0.125 * size));
        for (int i = 0; i < TRIANGLES; i++)
            for (int j = 0; j < i; j++)
                count += candidates(i, j);
        snprintf(key, sizeof key, "%d_%d", TRIANGLES, size);
        expect_number(text, key, count);
    }
    expect_number(text, "64_pairs", 15.0 * TRIANGLES * (TRIANGLES - 1) / 2);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/candidate_counts",
                    candidates_are_those_of_all_pairs);
}
