#include "figures/numbers.h"

static const double edge_at[2][2][3] = {{{0.35, 0.1, 0.8}, {0.2, 0.2, 1.7}},
                                        {{0, -0.3, -0.7}, {-0.2, 0, 0.5}}};
static const double triangle_at[2][3][3] = {
    {{-1, -0.7, -0.1}, {1, -0.8, 0.1}, {0.1, 1, 0}},
    {{-0.9, -0.9, 0.1}, {0.9, -0.7, 0}, {-0.1, 1, 0.15}}};

/// Whether the edge and the triangle, straight and flat at the ends, cross.
static bool cross_at(const tf_worldline e[2], const tf_worldline v[3], int t)
{
    oracle_simplex s = {2, {&e[0].at[t], &e[1].at[t]}};
    oracle_simplex r = {3, {&v[0].at[t], &v[1].at[t], &v[2].at[t]}};
    return oracle_slices_meet(3, &s, &r);
}

START_TEST(balloon_wraps_where_the_edge_crosses)
{
    tf_worldline e[2], v[3];
    for (int i = 0; i < 2; i++)
        e[i] = tf_worldline_between(3, edge_at[0][i], edge_at[1][i]);
    for (int i = 0; i < 3; i++)
        v[i] = tf_worldline_between(3, triangle_at[0][i], triangle_at[1][i]);
    char *text = printed(&fig_triangle_differences);
    expect_number(text, "toi", oracle_time(3, 1, &e[0], 3, v));
    expect_number(text, "degree_start", cross_at(e, v, 0));
    expect_number(text, "degree_end", cross_at(e, v, 1));
    free(text);

    // It is the only contact.
    ck_assert_double_lt(oracle_time(3, 1, &e[1], 3, v), 0);
    for (int i = 0; i < 3; i++) {
        const tf_worldline side[2] = {v[i == 0], v[i == 2 ? 1 : 2]};
        ck_assert_double_lt(oracle_time(3, 2, e, 2, side), 0);
    }
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/triangle_differences",
                    balloon_wraps_where_the_edge_crosses);
}
