#include "figures/numbers.h"

/// Whether the edges, straight at both ends of the step, cross.
static bool cross_at(const tf_worldline first[2], const tf_worldline second[2],
                     int t)
{
    oracle_simplex s = {2, {&first[0].at[t], &first[1].at[t]}};
    oracle_simplex r = {2, {&second[0].at[t], &second[1].at[t]}};
    return oracle_slices_meet(2, &s, &r);
}

START_TEST(band_winds_where_edges_cross)
{
    const tf_worldline e[2] = {tf_worldline_between(2, (double[]){-1.3, -0.3},
                                                    (double[]){-0.75, -0.35}),
                               tf_worldline_between(2, (double[]){-0.35, 0.45},
                                                    (double[]){0.85, 0.1})};
    const tf_worldline g[2] = {
        tf_worldline_between(2, (double[]){0.3, -0.9}, (double[]){0.1, -0.7}),
        tf_worldline_between(2, (double[]){0.5, 0.8}, (double[]){0.15, 1})};
    char *text = printed(&fig_edge_differences);
    expect_number(text, "toi", oracle_time(2, 1, &e[1], 2, g));

    // The border of a parallelogram winds around what is inside, once.
    expect_number(text, "winding_start", cross_at(e, g, 0));
    expect_number(text, "winding_end", cross_at(e, g, 1));
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/edge_differences", band_winds_where_edges_cross);
}
