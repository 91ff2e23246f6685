#include "simulate/flag.h"

#include "support/support.h"

START_TEST(a_flag_is_fixed_at_its_pole)
{
    tf_stage stage = {.body.axes = 3};
    tf_build_flag(&stage, 6);
    ck_assert_int_eq(stage.handles, 0);
    for (int v = 0; v < 7 * 10; v++)
        if (stage.body.position[3 * v] < 0.031)
            ck_assert_double_eq(stage.body.mass[v], 0);
        else
            ck_assert_double_gt(stage.body.mass[v], 0);
    for (int v = 7 * 10; v < stage.body.vertices; v++) {
        ck_assert_double_eq(stage.body.mass[v], 0);
        ck_assert_double_lt(stage.body.position[3 * v], 0.021);
    }
    tf_body_free(&stage.body);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/flag");
    TCase *tcase = tcase_create("stage");
    tcase_add_test(tcase, a_flag_is_fixed_at_its_pole);
    suite_add_tcase(suite, tcase);
    return suite;
}
