#include "figures/numbers.h"

START_TEST(bounds_hold_and_hardly_matter)
{
    char *text = printed(&fig_bound_margins);
    // Half of 8,000 queries have three pairs of six determinants, half four.
    expect_number(text, "near_count", 4000 * (18 + 24));
    expect_number(text, "rest_count", number_of(text, "near_count"));
    expect_number(text, "error_count", number_of(text, "near_count"));
    expect_number(text, "ranges", 256);

    // Seven roundings of a permanent of up to six terms, which are at most one
    // volume each, or two where a vector is that of an edge.
    double permanent = number_of(text, "permanent_largest");
    ck_assert_double_lt(permanent, 84.1);
    ck_assert_double_gt(permanent, number_of(text, "error_largest"));
    ck_assert_double_gt(number_of(text, "error_largest"), 1);

    // What moves is beyond the bound, what rests hardly ever.
    expect_number(text, "near_small", 0);
    ck_assert_double_gt(number_of(text, "rest_small"),
                        0.99 * number_of(text, "rest_count"));
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/bound_margins", bounds_hold_and_hardly_matter);
}
