#include "figures/numbers.h"

/// The bar stands across, from y = -1 to y = 1.
static double time_of(const tf_worldline propeller[2], const double start[2],
                      const double end[2])
{
    tf_worldline bar[2];
    for (int i = 0; i < 2; i++) {
        double y = 2 * i - 1;
        bar[i] = tf_worldline_between(3, (double[]){start[0], y, start[1]},
                                      (double[]){end[0], y, end[1]});
    }
    return oracle_time(3, 2, propeller, 2, bar);
}

START_TEST(one_order_meets_the_bar)
{
    tf_worldline left =
        tf_worldline_between(3, (double[]){-1, 0, 0}, (double[]){-1, 0, -1});
    tf_worldline right =
        tf_worldline_between(3, (double[]){1, 0, 0}, (double[]){1, 0, 1});
    double up = time_of((tf_worldline[]){left, right}, (double[]){0, 0.375},
                        (double[]){0, 0.375});
    double down = time_of((tf_worldline[]){right, left}, (double[]){1, 0.1875},
                          (double[]){0, 0.1875});
    char *text = printed(&fig_propeller_and_bar);
    expect_number(text, "up_hit", up >= 0);
    expect_number(text, "up_toi", up);
    expect_number(text, "down_hit", down >= 0);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/propeller_and_bar", one_order_meets_the_bar);
}
