#include "figures/numbers.h"

#include "support/winding.h"

enum {
    CURVE = 8,
    LOOP = 5
};

static const double curve[2][2 * (CURVE + 2)] = {
    {-0.5, -0.87, 0.34, -0.94, 0.82, -0.57, 1,   0,    0.82, 0.57,
     0.34, 0.94,  -0.5, 0.87,  -1,   0,     0.1, 0.35, 1.35, 0},
    {-0.6, -1.05, 1.2,  -1,   1.1,  -0.5, -0.5, 0.05, 1.1, 0.5,
     1.2,  1,     -0.6, 1.05, -1.3, 0,    0.7,  0.72, 0.4, 0.02}};
static const double loops[2][3 * 2 * LOOP] = {
    {-1.5, -0.7, 0.1,  0.2,  -1,   -0.2, 1,   -0.1, 0.2,  0.3,
     0.9,  0,    -1.3, 0.8,  -0.1, 0.1,  0,   0.2,  0.7,  0.1,
     -0.9, 1.9,  0,    -0.7, 2,    0.1,  0.7, 0.9,  -0.1, 1},
    {-1.2, -0.9, -0.5, 0.8,  -0.8, 0.3,  0.7, 0.3, 0.5, 0.1,
     0.9,  -0.6, -1.4, 0.4,  0.5,  -0.5, 0.1, 0.3, 0.1, 0.2,
     -1,   1.6,  -0.4, -0.4, 1.9,  0.5,  0.3, 0.5, 0,   1.1}};

/// A closed polygon of vertices in the order of their indices.
static cycle polygon(int count, int first, int edge[])
{
    for (int i = 0; i < count; i++) {
        edge[2 * i] = first + i;
        edge[2 * i + 1] = first + (i + 1) % count;
    }
    return (cycle){count, 2, edge};
}

START_TEST(both_ends_have_the_same_numbers)
{
    static const char *const when[2] = {"start", "end"};
    int edge[2 * CURVE], other[2 * LOOP];
    char *text = printed(&fig_no_tunneling), key[32];
    expect_number(text, "contacts", 0);
    for (int t = 0; t < 2; t++) {
        cycle around = polygon(CURVE, 0, edge);
        for (int k = 0; k < 2; k++) {
            snprintf(key, sizeof key, "winding_%d_%s", k, when[t]);
            expect_number(text, key,
                          winding_number(2, curve[t], &around, CURVE + k));
            expect_number(text, key, 1 - k);
        }
        cycle first = polygon(LOOP, 0, edge);
        cycle second = polygon(LOOP, LOOP, other);
        snprintf(key, sizeof key, "linking_%s", when[t]);
        expect_number(text, key, linking_number(loops[t], &first, &second));
        expect_number(text, key, -1);
    }
    expect_number(text, "winding_0_half", 1);
    expect_number(text, "winding_1_half", 0);
    expect_number(text, "linking_half", -1);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/no_tunneling", both_ends_have_the_same_numbers);
}
