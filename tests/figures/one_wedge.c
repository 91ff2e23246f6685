#include "figures/numbers.h"

START_TEST(the_parts_add_up)
{
    char *text = printed(&fig_one_wedge);
    expect_number(text, "share_0", 1);
    expect_number(text, "share_1", 1);
    expect_number(text, "share_2", 1);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/one_wedge", the_parts_add_up);
}
