#include "figures/numbers.h"

START_TEST(the_parts_are_all)
{
    char *text = printed(&fig_flow_step_costs);
    expect_number(text, "triangles", 5120);
    ck_assert_double_gt(number_of(text, "step"), 0);
    expect_number(text, "improve",
                  100 - number_of(text, "reconnect") -
                      number_of(text, "advance"));
    // As the text has it.
    ck_assert_double_gt(number_of(text, "improve"), number_of(text, "advance"));
    ck_assert_double_gt(number_of(text, "reconnect"), 25);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/flow_step_costs", the_parts_are_all);
}
