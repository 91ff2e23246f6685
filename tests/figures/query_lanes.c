#include "figures/numbers.h"

START_TEST(lanes_are_one_line)
{
    char *text = printed(&fig_query_lanes);
    expect_number(text, "rows_wanted", 8);
    expect_number(text, "lanes_wanted", 1);
    expect_number(text, "bytes", 2 * 4 * 3 * 8);
    expect_number(text, "lines", 24);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/query_lanes", lanes_are_one_line);
}
