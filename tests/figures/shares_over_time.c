#include "figures/numbers.h"

#include "support/queries.h"

START_TEST(turns_are_those_of_the_staircase)
{
    char *text = printed(&fig_shares_over_time);
    double coordinate[3], toi = number_of(text, "toi"), sum = 0;
    for (int i = 0; i < 3; i++) {
        const char *const key[] = {"w_0", "w_1", "w_2"};
        sum += coordinate[i] = number_of(text, key[i]);
    }
    ck_assert_double_eq_tol(sum, 1, 1e-15);
    for (int i = 0; i < 3; i++) {
        // Only one vertex moves, by 1.
        const char *const key[] = {"b_0", "b_1", "b_2"};
        tf_worldline vertex[3];
        double place[2];
        for (int v = 0; v < 3; v++)
            vertex[v] = tf_worldline_between(2, (double[]){0, 0},
                                             (double[]){v == i, 0});
        staircase_point(2, 3, vertex, coordinate, toi, place);
        expect_number(text, key[i], place[0]);
    }
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/shares_over_time",
                    turns_are_those_of_the_staircase);
}
