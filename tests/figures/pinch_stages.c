#include "figures/numbers.h"

START_TEST(one_part_becomes_two)
{
    char *text = printed(&fig_pinch_stages);
    expect_number(text, "done", 1);
    expect_number(text, "ring", 6);
    expect_number(text, "parts_before", 1);
    expect_number(text, "parts_after", 2);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/pinch_stages", one_part_becomes_two);
}
