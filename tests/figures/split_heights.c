#include "figures/numbers.h"

// The heights that the text computes for a sphere of infinite radius: a vertex
// sinks by 1/12 if six triangles are around it, by 1/10 if the split has made
// them smaller by one.
START_TEST(a_dent_is_spread)
{
    char *text = printed(&fig_split_heights);
    ck_assert_double_eq_tol(number_of(text, "level"), 0, 1e-3);
    ck_assert_double_eq_tol(number_of(text, "butterfly"), 1, 1e-3);
    ck_assert_double_eq_tol(number_of(text, "lowest"), 1 - 1.0 / 10, 0.01);
    ck_assert_double_eq_tol(number_of(text, "highest"), 1 - 1.0 / 12, 0.01);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/split_heights", a_dent_is_spread);
}
