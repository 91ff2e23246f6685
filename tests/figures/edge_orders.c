#include "figures/numbers.h"

START_TEST(one_order_meets_the_point)
{
    // It is told once: the other order does not meet.
    char *text = printed(&fig_edge_orders);
    ck_assert_str_eq(text, "toi 0.5\n");
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/edge_orders", one_order_meets_the_point);
}
