#include "figures/numbers.h"

START_TEST(one_order_meets_the_point)
{
    const double point[2][2] = {{4.5, 0.5}, {0.5, 1.5}};
    const double end[2][2][2] = {{{0, 0}, {0, 1}}, {{4, 0}, {4, 2}}};
    tf_worldline p = tf_worldline_between(2, point[0], point[1]), edge[2];
    double toi[2];
    for (int swapped = 0; swapped < 2; swapped++) {
        for (int i = 0; i < 2; i++) {
            const double(*own)[2] = end[swapped ? 1 - i : i];
            edge[i] = tf_worldline_between(2, own[0], own[1]);
        }
        toi[swapped] = oracle_time(2, 1, &p, 2, edge);
    }
    char *text = printed(&fig_edge_orders_moving);
    expect_number(text, "toi", toi[0]);
    expect_number(text, "toi_swapped", toi[1]);
    ck_assert_double_eq(toi[1], -1);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/edge_orders_moving", one_order_meets_the_point);
}
