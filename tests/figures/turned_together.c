#include "figures/numbers.h"

START_TEST(half_of_the_near_pairs_meet)
{
    char *text = printed(&fig_turned_together);
    double angle = number_of(text, "angle") * acos(-1) / 180;
    double c = cos(angle), s = sin(angle), x = 0.62, y = 0.1;
    tf_worldline line[3] = {
        tf_worldline_between(2, (double[]){x, y},
                             (double[]){c * x - s * y, s * x + c * y}),
        tf_worldline_between(2, (double[]){0, 0}, (double[]){0, 0}),
        tf_worldline_between(2, (double[]){1, 0}, (double[]){c, s})};
    expect_number(text, "toi", oracle_time(2, 1, line, 2, line + 1));
    // Three standard deviations of a share of one half.
    double most = 150 / sqrt(number_of(text, "pairs"));
    ck_assert_double_lt(number_of(text, "largest_difference"), most);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/turned_together", half_of_the_near_pairs_meet);
}
