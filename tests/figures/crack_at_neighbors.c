#include "figures/numbers.h"

#include "support/oracle.h"

static const double at[5][2][3] = {{{0, 0, 0}, {0, -1, 0}},
                                   {{4, 0, 0}, {4, 1, 0}},
                                   {{2, 4, 0}, {2, 4, 0}},
                                   {{2, -4, 0}, {2, -4, 0}},
                                   {{2, 0.25, 1.5}, {2, 0.25, -1.5}}};

/// Whether the particle meets a triangle that is swept in this order, and when.
static bool meet(int a, int b, int c, double *time)
{
    const int v[3] = {a, b, c};
    tf_worldline corner[3];
    for (int i = 0; i < 3; i++)
        corner[i] = tf_worldline_between(3, at[v[i]][0], at[v[i]][1]);
    tf_worldline particle = tf_worldline_between(3, at[4][0], at[4][1]);
    mpq_t toi;
    mpq_init(toi);
    bool hit = oracle_meet(3, 1, &particle, 3, corner, toi);
    if (hit)
        *time = mpq_get_d(toi);
    mpq_clear(toi);
    return hit;
}

START_TEST(a_private_order_opens_a_crack)
{
    char *text = printed(&fig_crack_at_neighbors);
    double time = -1;
    expect_number(text, "private_hits",
                  meet(0, 1, 2, &time) + meet(1, 0, 3, &time));
    expect_number(text, "private_hits", 0);
    expect_number(text, "shared_hits",
                  meet(0, 1, 2, &time) + meet(0, 1, 3, &time));
    expect_number(text, "shared_hits", 1);
    expect_number(text, "toi", time);
    // Between the creases (2, 1/2) and (2, -1/2).
    expect_number(text, "width", 1);
    expect_number(text, "length", 4);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/crack_at_neighbors",
                    a_private_order_opens_a_crack);
}
