#include "figures/numbers.h"

/// The edges of the picture, counted by hand: five triangles and a rod.
START_TEST(edges_are_those_of_the_picture)
{
    static const int expected[] = {1, 3, 4, 12, 14, 15, 16, 25, 34, 45, 46, 57};
    enum {
        EDGES = sizeof expected / sizeof *expected
    };
    char *text = printed(&fig_derived_edges);
    expect_number(text, "triangles", 5);
    expect_number(text, "records", 16);
    expect_number(text, "edges", EDGES);
    for (int i = 0; i < EDGES; i++) {
        char key[16];
        snprintf(key, sizeof key, "edge_%d", i);
        expect_number(text, key, expected[i]);
    }
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/derived_edges", edges_are_those_of_the_picture);
}
