#include "figures/numbers.h"

/// Rows of each kind: edge through triangle, point on triangle, edge on edge.
static const int expected[6][3] = {{2, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                   {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

START_TEST(each_scene_lists_its_kind)
{
    static const char *const key[3] = {"edge_triangle", "point_triangle",
                                       "edge_edge"};
    char *text = printed(&fig_static_intersections);
    for (int i = 0; i < 6; i++)
        for (int k = 0; k < 3; k++) {
            char name[32];
            snprintf(name, sizeof name, "%s_%d", key[k], i);
            expect_number(text, name, expected[i][k]);
        }
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/static_intersections", each_scene_lists_its_kind);
}
