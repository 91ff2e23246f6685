#include "figures/numbers.h"

#include "support/queries.h"

START_TEST(gap_is_between_the_creases)
{
    // The crease is the middle of the edge at half time, in either order.
    const tf_worldline edge[2] = {
        tf_worldline_between(2, (double[]){0, 2}, (double[]){0, 0}),
        tf_worldline_between(2, (double[]){3, 0}, (double[]){3, 2})};
    const tf_worldline turned[2] = {edge[1], edge[0]};
    const double half[2] = {0.5, 0.5};
    double upper[2], lower[2];
    staircase_point(2, 2, edge, half, 0.5, upper);
    staircase_point(2, 2, turned, half, 0.5, lower);
    char *text = printed(&fig_swept_edge);
    expect_number(text, "gap", hypot(upper[0] - lower[0], upper[1] - lower[1]));
    expect_number(text, "gap", 2); // by hand
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/swept_edge", gap_is_between_the_creases);
}
