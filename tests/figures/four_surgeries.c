#include "figures/numbers.h"

START_TEST(all_are_done)
{
    char *text = printed(&fig_four_surgeries);
    expect_number(text, "done", 4);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/four_surgeries", all_are_done);
}
