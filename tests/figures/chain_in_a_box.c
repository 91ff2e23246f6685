#include "figures/numbers.h"

START_TEST(the_chain_needs_no_failsafe)
{
    char *text = printed(&fig_chain_in_a_box);
    expect_number(text, "failsafe", 0);
    expect_number(text, "step", number_of(text, "steps") / 2);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/chain_in_a_box", the_chain_needs_no_failsafe);
}
