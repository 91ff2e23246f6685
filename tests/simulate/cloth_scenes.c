// The scenes of cloth: each starts clear, and has what its name says.
#include "simulate/cloth_scenes.h"

#include "support/simulations.h"
#include "support/support.h"

#include <math.h>
#include <string.h>

START_TEST(every_scene_is_complete)
{
    const tf_scene *scene = &tf_cloth_scenes[_i];
    ck_assert_ptr_eq(scene->kind, &tf_cloth_kind);
    ck_assert_ptr_eq(tf_scene_named(tf_cloth_scenes, scene->name), scene);
    ck_assert_uint_gt(strlen(scene->shows), 10);
    ck_assert_uint_gt(strlen(scene->resolution.counts), 10);
    ck_assert_double_ge(scene->resolution.usual, scene->resolution.least);
    ck_assert_double_ge(scene->resolution.most, scene->resolution.usual);
    ck_assert_double_gt(scene->resolution.least, 0);
    ck_assert_int_gt(scene->steps, 100);
    ck_assert_double_gt(scene->step, 0);
}
END_TEST

// Each scene's size, from the smallest on.
START_TEST(every_scene_starts_clear)
{
    const tf_scene *scene = &tf_cloth_scenes[_i];
    int least = (int)scene->resolution.least;
    int usual = (int)scene->resolution.usual;
    int sizes[] = {least, least + 1, least + 2, usual, usual * 3 / 2};
    for (int i = 0; i < cases(5); i++) {
        tf_scene_setup setup = setup_of(scene, sizes[i]);
        ck_assert_int_gt(setup.body.elastics, 0);
        expect_clear(&setup.body);
        tf_body_free(&setup.body);
    }
}
END_TEST

START_TEST(scripts_move_scripted_vertices_and_end_in_time)
{
    const tf_scene *scene = &tf_cloth_scenes[_i];
    tf_scene_setup setup = setup_of(scene, scene->resolution.least);
    int loose = 0;
    for (int v = 0; v < setup.body.vertices; v++)
        loose += setup.body.mass[v] > 0;
    ck_assert_int_gt(loose, 0);
    for (int i = 0; i < setup.scripts; i++) {
        const tf_script *script = &setup.script[i];
        ck_assert_int_gt(script->count, 0);
        for (int v = 0; v < script->count; v++)
            ck_assert_double_eq(setup.body.mass[script->first + v], 0);
        ck_assert_double_lt(script->end, scene->steps * scene->step);
    }
    tf_body_free(&setup.body);
}
END_TEST

// What falls --------------------------------------------------------------------

static tf_scene_setup setup_named(const char *name, int size)
{
    return setup_of(tf_scene_named(tf_cloth_scenes, name), size);
}

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
    tf_scene_setup setup = setup_named("sphere", 10);
    const tf_script *ball = &setup.script[0];
    ck_assert_int_eq(setup.scripts, 1);
    ck_assert_int_eq(ball->first, 11 * 11);
    ck_assert_double_gt(ball->turn, 1);
    for (int v = 0; v < setup.body.vertices; v++)
        ck_assert_int_eq(setup.body.mass[v] > 0, v < 11 * 11);
    for (int v = ball->first; v < ball->first + ball->count; v++)
        ck_assert_double_lt(setup.body.position[3 * v + 2],
                            setup.body.position[2]);
    ck_assert_double_eq_tol(mass_of(&setup.body), 0.15, 1e-9);
    tf_body_free(&setup.body);
}
END_TEST

START_TEST(five_sheets_are_stacked)
{
    tf_scene_setup setup = setup_named("stack", 6);
    for (int v = 0; v < 5 * 49; v++)
        ck_assert_double_eq_tol(setup.body.position[3 * v + 2],
                                0.06 * (v / 49 + 1), 1e-12);
    ck_assert_double_eq_tol(mass_of(&setup.body), 5 * 0.36 * 0.15, 1e-9);
    tf_body_free(&setup.body);
}
END_TEST

START_TEST(a_chain_has_its_links)
{
    for (int links = 40; links < 60; links++) {
        tf_scene_setup setup = setup_named("plane-chain", links);
        ck_assert_int_eq(setup.body.edges, links + 3);
        ck_assert_int_eq(setup.body.vertices, links + 1 + 4);
        ck_assert_int_eq(setup.body.elastics, links + links - 1);
        ck_assert_double_eq_tol(mass_of(&setup.body), 0.5, 1e-9);
        for (int v = 0; v < links; v++)
            ck_assert_double_gt(setup.body.position[2 * v + 3],
                                setup.body.position[2 * v + 1]);
        tf_body_free(&setup.body);
    }
}
END_TEST

// What is pulled ----------------------------------------------------------------

/// The mean of where a script's vertices start.
static void find_middle(const tf_scene_setup *setup, int script,
                        double middle[3])
{
    const tf_script *h = &setup->script[script];
    for (int k = 0; k < 3; k++) {
        middle[k] = 0;
        for (int v = h->first; v < h->first + h->count; v++)
            middle[k] += setup->body.position[3 * v + k] / h->count;
    }
}

static int count_scripted(const tf_body *body)
{
    int count = 0;
    for (int v = 0; v < body->vertices; v++)
        count += body->mass[v] == 0;
    return count;
}

START_TEST(a_strip_is_turned_at_both_ends)
{
    tf_scene_setup setup = setup_named("twist", 4);
    double left[3], right[3];
    ck_assert_int_eq(setup.scripts, 2);
    ck_assert_int_eq(count_scripted(&setup.body), 2 * 5);
    find_middle(&setup, 0, left);
    find_middle(&setup, 1, right);
    ck_assert_double_eq_tol(left[0], -0.6, 1e-12);
    ck_assert_double_eq_tol(right[0], 0.6, 1e-12);
    ck_assert_double_eq(setup.script[0].turn, -setup.script[1].turn);
    ck_assert_double_gt(setup.script[0].shift[0], 0);
    ck_assert_double_lt(setup.script[1].shift[0], 0);
    tf_body_free(&setup.body);
}
END_TEST

START_TEST(a_rope_is_pulled_at_both_ends)
{
    tf_scene_setup setup = setup_named("knot", 3);
    double first[3], last[3];
    ck_assert_int_eq(setup.scripts, 2);
    ck_assert_int_eq(count_scripted(&setup.body), 4 * 6);
    ck_assert_int_eq(setup.script[1].first + setup.script[1].count,
                     setup.body.vertices);
    find_middle(&setup, 0, first);
    find_middle(&setup, 1, last);
    ck_assert_double_gt(first[1], last[1]);
    ck_assert_double_gt(setup.script[0].shift[1], 0);
    ck_assert_double_lt(setup.script[1].shift[1], 0);
    tf_body_free(&setup.body);
}
END_TEST

START_TEST(a_curtain_is_pulled_at_its_middle)
{
    for (int size = 10; size < 14; size++) {
        tf_scene_setup setup = setup_named("curtain", size);
        double middle[2][3];
        for (int h = 0; h < 2; h++) {
            find_middle(&setup, h, middle[h]);
            ck_assert_int_eq(setup.script[h].count, 2);
            ck_assert_double_lt(setup.script[h].shift[2], -0.5);
        }
        for (int k = 0; k < 2; k++)
            ck_assert_double_le(fabs(middle[0][k] + middle[1][k]), 1e-12);
        tf_body_free(&setup.body);
    }
}
END_TEST

// What is blown -----------------------------------------------------------------

START_TEST(a_flag_is_fixed_at_its_pole)
{
    tf_scene_setup setup = setup_named("flag", 6);
    ck_assert_int_eq(setup.scripts, 0);
    for (int v = 0; v < 7 * 10; v++)
        if (setup.body.position[3 * v] < 0.031)
            ck_assert_double_eq(setup.body.mass[v], 0);
        else
            ck_assert_double_gt(setup.body.mass[v], 0);
    for (int v = 7 * 10; v < setup.body.vertices; v++) {
        ck_assert_double_eq(setup.body.mass[v], 0);
        ck_assert_double_lt(setup.body.position[3 * v], 0.021);
    }
    tf_body_free(&setup.body);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/cloth_scenes");
    TCase *all = tcase_create("all");
    int scenes = scene_count(tf_cloth_scenes);
    tcase_add_loop_test(all, every_scene_is_complete, 0, scenes);
    tcase_add_loop_test(all, every_scene_starts_clear, 0, scenes);
    tcase_add_loop_test(all, scripts_move_scripted_vertices_and_end_in_time, 0,
                        scenes);
    suite_add_tcase(suite, all);
    TCase *setup = tcase_create("setup");
    tcase_add_test(setup, cloth_is_above_a_ball_that_turns);
    tcase_add_test(setup, five_sheets_are_stacked);
    tcase_add_test(setup, a_chain_has_its_links);
    tcase_add_test(setup, a_strip_is_turned_at_both_ends);
    tcase_add_test(setup, a_rope_is_pulled_at_both_ends);
    tcase_add_test(setup, a_curtain_is_pulled_at_its_middle);
    tcase_add_test(setup, a_flag_is_fixed_at_its_pole);
    suite_add_tcase(suite, setup);
    return suite;
}
