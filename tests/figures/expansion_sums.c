#include "figures/numbers.h"

/// Merging keeps the value, and what cancels leaves one term.
START_TEST(sums_are_those_of_the_products)
{
    char *text = printed(&fig_expansion_sums);
    expect_number(text, "cancelling", 13 * 11 - 10 * 14);
    expect_number(text, "cancelling_terms", 1);
    expect_number(text, "growing", 208 * 176 + 13 * 13);
    expect_number(text, "growing_terms", 3);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/expansion_sums", sums_are_those_of_the_products);
}
