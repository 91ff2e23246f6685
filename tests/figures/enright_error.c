#include "figures/numbers.h"

START_TEST(the_order_is_nearly_two)
{
    char *text = printed(&fig_enright_error);
    ck_assert_double_eq_tol(number_of(text, "slope"), 2, 0.15);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/enright_error", the_order_is_nearly_two);
}
