#include "figures/numbers.h"

START_TEST(more_sweeps_take_fewer_rounds)
{
    char *text = printed(&fig_sweep_counts);
    double few = number_of(text, "rounds_few");
    double usual = number_of(text, "rounds_usual");
    double many = number_of(text, "rounds_many");
    ck_assert_double_gt(few, usual);
    ck_assert_double_gt(usual, many);
    expect_number(text, "many", 500);
    expect_number(text, "rounds_many", number_of(text, "beads"));
    ck_assert_double_lt(number_of(text, "visits_few"),
                        number_of(text, "visits_usual"));
    ck_assert_double_lt(number_of(text, "visits_usual"),
                        number_of(text, "visits_many") / 2.9);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/sweep_counts", more_sweeps_take_fewer_rounds);
}
