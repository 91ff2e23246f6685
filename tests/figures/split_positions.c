#include "figures/numbers.h"

START_TEST(the_parts_add_up)
{
    char *text = printed(&fig_split_positions);
    expect_number(text, "share_0", 1);
    expect_number(text, "share_1", 1);
    expect_number(text, "share_2", 1);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/split_positions", the_parts_add_up);
}
