#include "figures/numbers.h"

START_TEST(pushes_are_the_least)
{
    // The plank is a body of mass 2 with the velocity 1, the fly rests.
    char *text = printed(&fig_row_visit);
    expect_number(text, "fly_still", 2 / 3.);
    expect_number(text, "plank_still", 2 / 3.);
    expect_number(text, "fly_bounced", 4 / 3.);
    expect_number(text, "plank_bounced", 1 / 3.);
    expect_number(text, "energy_proposed", 1);
    expect_number(text, "energy_still", 2 / 3.);
    expect_number(text, "energy_bounced", 1);

    // The approach is 1, so friction takes as much as its coefficient.
    double sliding = number_of(text, "sliding");
    expect_number(text, "sliding_0.5", sliding - 0.5);
    expect_number(text, "sliding_1.5", 0);
    ck_assert_double_lt(sliding, 1.5);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/row_visit", pushes_are_the_least);
}
