#include "figures/numbers.h"

START_TEST(about_an_eighth_is_exact)
{
    char *text = printed(&fig_rounded_midpoints);
    expect_number(text, "length", 0.02);
    double edges = number_of(text, "edges"), share = number_of(text, "exact");
    // A half is exact if three last bits of sums are zero: of short edges one in
    // eight, but near zero and across powers of two it is otherwise.
    ck_assert_double_gt(edges, 10000);
    ck_assert_double_gt(share, 12.5);
    ck_assert_double_lt(share, 17);
    ck_assert_double_gt(number_of(text, "least"), 11.5);
    ck_assert_double_lt(number_of(text, "most"), 32);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/rounded_midpoints", about_an_eighth_is_exact);
}
