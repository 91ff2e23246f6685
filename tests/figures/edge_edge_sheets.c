#include "figures/numbers.h"

#include "support/oracle.h"

static const double at[2][2][2][3] = {
    {{{-2.625, -1, -1}, {-2.875, -0.5, 0.5}},
     {{1.375, 0.5, -2}, {1.375, -0.5, 2.75}}},
    {{{0.5, -1.375, 2.75}, {-0.25, -1.375, -2}},
     {{-0.5, 2.625, 1.5}, {0.75, 2.625, -1}}}};

/// The triangle of an edge's sweep: first the one that moves with vertex 1.
static oracle_simplex triangle(const tf_worldline edge[2], int i)
{
    return (oracle_simplex){3,
                            {&edge[0].at[0],
                             i == 0 ? &edge[1].at[0] : &edge[0].at[1],
                             &edge[1].at[1]}};
}

START_TEST(the_four_pairs_do_what_the_oracle_says)
{
    tf_worldline edge[2][2];
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 2; i++)
            edge[k][i] = tf_worldline_between(3, at[k][i][0], at[k][i][1]);
    char *text = printed(&tf_figure_edge_edge_sheets);
    mpq_t toi;
    mpq_init(toi);
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            oracle_simplex s = triangle(edge[0], i), r = triangle(edge[1], j);
            char key[16];
            snprintf(key, sizeof key, "hit_%d%d", i, j);
            expect_number(text, key, oracle_simplices_meet(3, &s, &r, toi));
        }
    ck_assert(oracle_meet(3, 2, edge[0], 2, edge[1], toi));
    expect_number(text, "toi", mpq_get_d(toi));
    mpq_clear(toi);

    // By hand: (a0 + a1 + 2 a1') / 4 = (2 b0 + b0' + b1') / 4.
    expect_number(text, "toi", 0.5);
    expect_number(text, "weight_a1", 0.75);
    expect_number(text, "weight_b1", 0.25);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/edge_edge_sheets",
                    the_four_pairs_do_what_the_oracle_says);
}
