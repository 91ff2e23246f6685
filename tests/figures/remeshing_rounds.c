#include "figures/numbers.h"

START_TEST(the_loop_calms_down)
{
    char *text = printed(&fig_remeshing_rounds);
    expect_number(text, "rounds", 10);
    expect_number(text, "splits", 0);
    expect_number(text, "collapses", 0);
    expect_number(text, "flips", 0);
    expect_number(text, "moves", 1);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/remeshing_rounds", the_loop_calms_down);
}
