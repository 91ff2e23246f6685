#include "program/solvers.h"

#include "response/conjugate_residuals.h"
#include "response/gauss_seidel.h"
#include "response/minres.h"
#include "response/normal_residuals.h"
#include "support/support.h"

START_TEST(every_name_finds_its_solver)
{
    ck_assert_ptr_eq(tf_solver_named("gauss-seidel"), &tf_gauss_seidel);
    ck_assert_ptr_eq(tf_solver_named("conjugate-residuals"),
                     &tf_conjugate_residuals);
    ck_assert_ptr_eq(tf_solver_named("minres"), &tf_minres);
    ck_assert_ptr_eq(tf_solver_named("normal-residuals"), &tf_normal_residuals);
    ck_assert_str_eq(
        TF_SOLVER_NAMES,
        "gauss-seidel, conjugate-residuals, minres or normal-residuals");
}
END_TEST

START_TEST(other_names_find_nothing)
{
    static const char *const names[] = {"", "gauss", "MINRES", "minres "};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        ck_assert_msg(!tf_solver_named(names[i]), "'%s'", names[i]);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/solvers");
    TCase *names = tcase_create("names");
    tcase_add_test(names, every_name_finds_its_solver);
    tcase_add_test(names, other_names_find_nothing);
    suite_add_tcase(suite, names);
    return suite;
}
