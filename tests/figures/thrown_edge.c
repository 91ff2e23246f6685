#include "figures/numbers.h"

// A point in each round; and one round more, in which the group is frozen, if a
// sum is rounded.
START_TEST(as_many_rounds_as_there_can_be)
{
    char *text = printed(&fig_thrown_edge);
    int vertices = (int)number_of(text, "vertices");
    expect_number(text, "rounds", vertices - 2);
    expect_number(text, "rounds_rounded", vertices - 1);
    for (int round = 1; round <= vertices - 2; round++) {
        char key[32];
        double far = 0.4 + 0.2 * round;
        snprintf(key, sizeof key, "displacement_%d", round);
        ck_assert_double_eq_tol(number_of(text, key),
                                round % 2 == 0 ? far : -far, 1e-12);
    }
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/thrown_edge", as_many_rounds_as_there_can_be);
}
