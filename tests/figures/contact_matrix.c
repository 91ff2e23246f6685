#include "figures/numbers.h"

// At each end, every edge meets the floor, and each of the three pairs of edges
// meets twice; there are three heights.
START_TEST(rows_repeat)
{
    char *text = printed(&fig_contact_matrix);
    expect_number(text, "rows", 2 * (3 + 2 * 3));
    expect_number(text, "zones", 2);
    expect_number(text, "rank", 2 * 3);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/contact_matrix", rows_repeat);
}
