#include "figures/numbers.h"

enum {
    MOST = 16
};

/// Rounds of one impulse for each pair that meets, worked out on a line.
static int rounds_alone(int beads)
{
    double d[MOST + 1] = {1};
    for (int rounds = 0;; rounds++) {
        bool met[MOST], any = false;
        for (int i = 0; i < beads; i++) {
            met[i] = d[i] >= d[i + 1] + 0x1p-10;
            any |= met[i];
        }
        if (!any)
            return rounds;
        for (int i = 0; i < beads; i++)
            if (met[i] && d[i] > d[i + 1]) {
                d[i] = i + 1 < beads ? (d[i] + d[i + 1]) / 2 : 0;
                if (i + 1 < beads)
                    d[i + 1] = d[i];
            }
    }
}

START_TEST(each_round_discovers_a_neighbor)
{
    char *text = printed(&fig_kept_rows);
    for (int beads = 2; beads <= MOST; beads++) {
        char key[32];
        snprintf(key, sizeof key, "alone_%d", beads);
        expect_number(text, key, rounds_alone(beads));
        snprintf(key, sizeof key, "kept_%d", beads);
        expect_number(text, key, beads);
    }
    expect_number(text, "library_part", 128);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/kept_rows", each_round_discovers_a_neighbor);
}
