#include "simulate/falling.h"

#include "support/support.h"

#include <math.h>

/// The mass of what is not scripted.
static double mass_of(const tf_body *body)
{
    double sum = 0;
    for (int v = 0; v < body->vertices; v++)
        sum += body->mass[v];
    return sum;
}

START_TEST(cloth_is_above_a_ball_that_turns)
{
    tf_stage stage = {.body.axes = 3};
    tf_build_sphere(&stage, 10);
    const tf_handle *ball = &stage.handle[0];
    ck_assert_int_eq(stage.handles, 1);
    ck_assert_int_eq(ball->first, 11 * 11);
    ck_assert_double_gt(ball->turn, 1);
    for (int v = 0; v < stage.body.vertices; v++)
        ck_assert_int_eq(stage.body.mass[v] > 0, v < 11 * 11);
    for (int v = ball->first; v < ball->first + ball->count; v++)
        ck_assert_double_lt(stage.body.position[3 * v + 2],
                            stage.body.position[2]);
    ck_assert_double_eq_tol(mass_of(&stage.body), 0.15, 1e-9);
    tf_body_free(&stage.body);
}
END_TEST

START_TEST(five_sheets_are_stacked)
{
    tf_stage stage = {.body.axes = 3};
    tf_build_stack(&stage, 6);
    for (int v = 0; v < 5 * 49; v++)
        ck_assert_double_eq_tol(stage.body.position[3 * v + 2],
                                0.06 * (v / 49 + 1), 1e-12);
    ck_assert_double_eq_tol(mass_of(&stage.body), 5 * 0.36 * 0.15, 1e-9);
    tf_body_free(&stage.body);
}
END_TEST

START_TEST(a_chain_has_its_links)
{
    for (int links = 40; links < 60; links++) {
        tf_stage stage = {.body.axes = 2};
        tf_build_chain(&stage, links);
        ck_assert_int_eq(stage.body.edges, links + 3);
        ck_assert_int_eq(stage.body.vertices, links + 1 + 4);
        ck_assert_int_eq(stage.body.elastics, links + links - 1);
        ck_assert_double_eq_tol(mass_of(&stage.body), 0.5, 1e-9);
        for (int v = 0; v < links; v++)
            ck_assert_double_gt(stage.body.position[2 * v + 3],
                                stage.body.position[2 * v + 1]);
        tf_body_free(&stage.body);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/falling");
    TCase *tcase = tcase_create("stages");
    tcase_add_test(tcase, cloth_is_above_a_ball_that_turns);
    tcase_add_test(tcase, five_sheets_are_stacked);
    tcase_add_test(tcase, a_chain_has_its_links);
    suite_add_tcase(suite, tcase);
    return suite;
}
