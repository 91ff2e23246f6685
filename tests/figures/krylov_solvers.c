#include "figures/numbers.h"

START_TEST(copies_add_no_rank)
{
    char *text = printed(&fig_krylov_solvers);
    double different = number_of(text, "different_rows");
    expect_number(text, "rank", different);
    expect_number(text, "rows", different + ceil(different / 5));
    free(text);
}
END_TEST

START_TEST(contradictions_do_no_harm_but_to_gradients)
{
    char *text = printed(&fig_krylov_solvers);
    double products = number_of(text, "residuals_products");
    ck_assert_double_ge(products, number_of(text, "rank"));
    ck_assert_double_lt(products, 1.6 * number_of(text, "rank"));
    ck_assert_double_eq_tol(number_of(text, "residuals_off"), products, 4);
    ck_assert_double_eq_tol(number_of(text, "minres_off"), products, 4);
    ck_assert_double_eq_tol(number_of(text, "minres_products"), products, 4);
    ck_assert_double_gt(number_of(text, "normal_products"), 2 * products);

    // At most one iterate could be nearer than the part that all have.
    double floor = number_of(text, "floor");
    ck_assert_double_gt(floor, 0);
    ck_assert_double_gt(number_of(text, "gradients_best"), floor);
    ck_assert_double_gt(number_of(text, "gradients_worst"), 1e5);
    free(text);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_of("figures/krylov_solvers", copies_add_no_rank);
    TCase *copies = tcase_create("copies");
    tcase_add_test(copies, contradictions_do_no_harm_but_to_gradients);
    suite_add_tcase(s, copies);
    return s;
}
