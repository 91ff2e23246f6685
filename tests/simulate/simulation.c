#include "simulate/simulation.h"

#include "support/scrambled.h"
#include "support/simulating.h"
#include "support/support.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static size_t state_size(const tf_simulation *s)
{
    return sizeof(double) * (size_t)(s->scene->axes * s->stage.body.vertices);
}

static void expect_same(const tf_simulation *a, const tf_simulation *b)
{
    ck_assert_int_eq(a->step, b->step);
    ck_assert_int_eq(a->scripted, b->scripted);
    ck_assert_mem_eq(a->position, b->position, state_size(a));
    ck_assert_mem_eq(a->velocity, b->velocity, state_size(a));
}

START_TEST(it_starts_at_rest)
{
    const tf_scene *scene = tf_scene_named("twist");
    tf_simulation *s = simulation_of(scene, 4);
    const tf_body *body = &s->stage.body;
    ck_assert_ptr_eq(s->scene, scene);
    ck_assert_int_eq(s->size, 4);
    ck_assert_int_eq(s->step, 0);
    ck_assert_mem_eq(s->position, body->position, state_size(s));
    for (int v = 0; v < body->vertices; v++) {
        ck_assert_double_eq(s->velocity[3 * v], 0);
        ck_assert_double_eq(s->inverse_mass[v],
                            body->mass[v] > 0 ? 1 / body->mass[v] : 0);
    }
    tf_simulation_free(s);
    tf_simulation_free(NULL);
}
END_TEST

// Gravity first gives a velocity, and then moves by it.
START_TEST(what_nothing_holds_falls)
{
    tf_simulation *s = simulation_of(tf_scene_named("plane-chain"), 40);
    double height = s->position[1], fallen = 0, g = s->scene->gravity;
    for (int i = 1; i <= 10; i++) {
        simulate_blindly(s);
        fallen += i * g * s->scene->step * s->scene->step;
    }
    double middle = 0, before = 0;
    for (int v = 0; v <= 40; v++) {
        middle += s->position[2 * v + 1] * s->stage.body.mass[v];
        before += s->stage.body.position[2 * v + 1] * s->stage.body.mass[v];
    }
    ck_assert_double_eq_tol(before - middle, fallen * 0.5, 1e-12);
    ck_assert_double_ne(s->position[1], height);
    ck_assert_double_eq(s->position[2 * 41], s->stage.body.position[2 * 41]);
    tf_simulation_free(s);
}
END_TEST

START_TEST(velocities_lead_from_start_to_end)
{
    tf_simulation *s = simulation_of(tf_scene_named("sphere"), 6);
    double *before = malloc(state_size(s));
    for (int i = 0; i < 40; i++) {
        memcpy(before, s->position, state_size(s));
        simulate_step(s, NULL);
        for (int j = 0; j < 3 * s->stage.body.vertices; j++)
            ck_assert_double_eq(s->velocity[j],
                                (s->position[j] - before[j]) / s->scene->step);
    }
    ck_assert_int_eq(s->step, 40);
    free(before);
    tf_simulation_free(s);
}
END_TEST

START_TEST(the_script_waits_for_what_is_held)
{
    tf_simulation *s = simulation_of(tf_scene_named("twist"), 2);
    ck_assert_int_eq(tf_simulation_propose(s), TF_OK);
    double there = s->end[0];
    ck_assert_double_ne(there, s->position[0]);
    s->end[0] = s->position[0];
    tf_simulation_accept(s, 1);
    ck_assert_int_eq(s->step, 1);
    ck_assert_int_eq(s->scripted, 0);
    ck_assert_int_eq(tf_simulation_propose(s), TF_OK);
    ck_assert_double_eq(s->end[0], there);
    tf_simulation_accept(s, 0);
    ck_assert_int_eq(s->scripted, 1);
    tf_simulation_free(s);
}
END_TEST

// Small enough to be quick, and long enough to meet something.
static const struct {
    const char *name;
    int size, steps;
} shorts[] = {{"sphere", 10, 40},      {"stack", 6, 40},     {"twist", 4, 60},
              {"knot", 3, 60},         {"curtain", 10, 200}, {"flag", 6, 60},
              {"plane-chain", 60, 120}};

START_TEST(threads_change_nothing)
{
    const tf_scene *scene = tf_scene_named(shorts[_i].name);
    int two = 2, three = 3;
    tf_parallel on_two = scrambled(&two), on_three = scrambled(&three);
    tf_simulation *s[3];
    for (int i = 0; i < 3; i++)
        s[i] = simulation_of(scene, shorts[_i].size);
    for (int step = 0; step < shorts[_i].steps; step++) {
        simulate_step(s[0], NULL);
        simulate_step(s[1], &on_two);
        simulate_step(s[2], &on_three);
        expect_same(s[0], s[1]);
        expect_same(s[0], s[2]);
    }
    for (int i = 0; i < 3; i++)
        tf_simulation_free(s[i]);
}
END_TEST

START_TEST(a_state_goes_on_as_it_would_have)
{
    const tf_scene *scene = tf_scene_named(shorts[_i].name);
    tf_simulation *whole = simulation_of(scene, shorts[_i].size);
    tf_simulation *later = simulation_of(scene, shorts[_i].size);
    int half = shorts[_i].steps * 2 / 3;
    for (int step = 0; step < half; step++)
        simulate_step(whole, NULL);
    memcpy(later->position, whole->position, state_size(whole));
    memcpy(later->velocity, whole->velocity, state_size(whole));
    later->step = whole->step;
    later->scripted = whole->scripted;
    for (int step = half; step < shorts[_i].steps; step++) {
        simulate_step(whole, NULL);
        simulate_step(later, NULL);
    }
    expect_same(whole, later);
    tf_simulation_free(whole);
    tf_simulation_free(later);
}
END_TEST

// What a step took --------------------------------------------------------------

static double ticks;

static double tick(void)
{
    return ticks++;
}

START_TEST(the_cost_is_known)
{
    tf_simulation *s = simulation_of(tf_scene_named("sphere"), 10);
    tf_step_way way = {.check = true, .clock = tick};
    tf_step_cost cost;
    do {
        ck_assert_int_eq(tf_simulation_step(s, &way, &cost), TF_OK);
        ck_assert_double_eq(cost.dynamics, 1);
        ck_assert_double_eq(cost.response, 1);
        way.check = false;
    } while (cost.report.first_contacts == 0);
    ck_assert_int_ge(cost.report.rounds[TF_ZONES], 1);
    ck_assert_uint_ge(cost.report.constraints, cost.report.first_contacts);
    tf_simulation_free(s);
}
END_TEST

START_TEST(a_start_that_is_not_clear_is_no_step)
{
    tf_simulation *s = simulation_of(tf_scene_named("sphere"), 10);
    tf_step_way way = {.check = true};
    tf_step_cost cost;
    s->position[2] -= 2;
    ck_assert_int_eq(tf_simulation_step(s, &way, &cost), TF_START_NOT_CLEAR);
    ck_assert_int_eq(s->step, 0);
    tf_simulation_free(s);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/simulation");
    TCase *steps = tcase_create("steps");
    tcase_add_test(steps, it_starts_at_rest);
    tcase_add_test(steps, what_nothing_holds_falls);
    tcase_add_test(steps, velocities_lead_from_start_to_end);
    tcase_add_test(steps, the_script_waits_for_what_is_held);
    tcase_add_test(steps, the_cost_is_known);
    tcase_add_test(steps, a_start_that_is_not_clear_is_no_step);
    suite_add_tcase(suite, steps);
    TCase *bits = tcase_create("bits");
    int some = (int)cases(sizeof shorts / sizeof *shorts);
    tcase_add_loop_test(bits, threads_change_nothing, 0, some);
    tcase_add_loop_test(bits, a_state_goes_on_as_it_would_have, 0, some);
    suite_add_tcase(suite, bits);
    return suite;
}
