#include "figures/numbers.h"

START_TEST(some_slip_through_without_a_tolerance)
{
    char *text = printed(&fig_vertex_rounding);
    double scenes = number_of(text, "scenes");
    expect_number(text, "exact", scenes);
    expect_number(text, "both_tolerant", scenes);
    expect_number(text, "none_tolerant", 0);
    double both = number_of(text, "both_zero");
    double one = number_of(text, "one_zero");
    double none = number_of(text, "none_zero");
    expect_number(text, "scenes", both + one + none);
    // About a quarter, and less, because a zero is a hit.
    ck_assert_msg(none > 0.15 * scenes && none < 0.25 * scenes,
                  "%g of %g slip through", none, scenes);
    ck_assert_msg(both > none && one > both, "%g, %g, %g", both, one, none);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/vertex_rounding",
                    some_slip_through_without_a_tolerance);
}
