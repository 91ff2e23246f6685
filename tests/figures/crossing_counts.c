#include "figures/numbers.h"

/// By hand: the points of the edge with x = 0 are at y = -2 t + 4 t^2, from 0
/// to 2 by way of -1/4, so the edge meets the points at y = 3/4 at t = 3/4, at
/// y = -3/16 at t = 1/8 and t = 3/8, and at y = -1/2 never.
START_TEST(edge_meets_the_points)
{
    char *text = printed(&fig_crossing_counts);
    expect_number(text, "toi_once", 0.75);
    expect_number(text, "toi_twice", 0.125);
    expect_number(text, "toi_never", -1);
    expect_number(text, "contacts_once", 1);
    expect_number(text, "contacts_twice", 2);
    expect_number(text, "contacts_never", 0);
    expect_number(text, "crossings_once", 1);
    expect_number(text, "crossings_twice", 2);
    expect_number(text, "crossings_never", 2);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/crossing_counts", edge_meets_the_points);
}
