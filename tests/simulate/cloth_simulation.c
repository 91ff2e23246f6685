#include "simulate/cloth_simulation.h"

#include "support/scrambled_workers.h"
#include "support/simulations.h"
#include "support/support.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static size_t state_size(const tf_cloth_simulation *s)
{
    return sizeof(double) *
           (size_t)(s->base.setup.body.axes * s->base.setup.body.vertices);
}

static void expect_same(const tf_cloth_simulation *a,
                        const tf_cloth_simulation *b)
{
    ck_assert_int_eq(a->base.step, b->base.step);
    ck_assert_int_eq(a->script_steps, b->script_steps);
    ck_assert_mem_eq(a->position, b->position, state_size(a));
    ck_assert_mem_eq(a->velocity, b->velocity, state_size(a));
}

START_TEST(cloth_starts_at_rest)
{
    tf_cloth_simulation *s = cloth_of("twist", 4);
    const tf_body *body = &s->base.setup.body;
    ck_assert_str_eq(s->base.scene->name, "twist");
    ck_assert_double_eq(s->base.resolution, 4);
    ck_assert_int_eq(s->base.step, 0);
    ck_assert_mem_eq(s->position, body->position, state_size(s));
    for (int v = 0; v < body->vertices; v++) {
        ck_assert_double_eq(s->velocity[3 * v], 0);
        ck_assert_double_eq(s->inverse_mass[v],
                            body->mass[v] > 0 ? 1 / body->mass[v] : 0);
    }
    cloth_simulation_free(s);
}
END_TEST

// Gravity first gives a velocity, and then moves by it.
START_TEST(unheld_cloth_falls_by_gravity)
{
    tf_cloth_simulation *s = cloth_of("plane-chain", 40);
    double height = s->position[1], fallen = 0, g = s->base.scene->gravity;
    for (int i = 1; i <= 10; i++) {
        simulate_blindly(s);
        fallen += i * g * s->base.scene->step * s->base.scene->step;
    }
    double middle = 0, before = 0;
    for (int v = 0; v <= 40; v++) {
        middle += s->position[2 * v + 1] * s->base.setup.body.mass[v];
        before +=
            s->base.setup.body.position[2 * v + 1] * s->base.setup.body.mass[v];
    }
    ck_assert_double_eq_tol(before - middle, fallen * 0.5, 1e-12);
    ck_assert_double_ne(s->position[1], height);
    ck_assert_double_eq(s->position[2 * 41],
                        s->base.setup.body.position[2 * 41]);
    cloth_simulation_free(s);
}
END_TEST

START_TEST(velocities_lead_from_start_to_end)
{
    tf_cloth_simulation *s = cloth_of("sphere", 6);
    double *before = malloc(state_size(s));
    for (int i = 0; i < 40; i++) {
        memcpy(before, s->position, state_size(s));
        simulate_step(s, NULL);
        const double *to = tf_resolver_unpushed(s->resolver);
        for (int j = 0; j < 3 * s->base.setup.body.vertices; j++)
            ck_assert_double_eq(s->velocity[j],
                                (to[j] - before[j]) / s->base.scene->step);
    }
    ck_assert_int_eq(s->base.step, 40);
    free(before);
    cloth_simulation_free(s);
}
END_TEST

START_TEST(the_script_waits_while_vertices_are_held)
{
    tf_cloth_simulation *s = cloth_of("twist", 2);
    ck_assert_int_eq(tf_cloth_propose(s), TF_OK);
    double there = s->end[0];
    ck_assert_double_ne(there, s->position[0]);
    s->end[0] = s->position[0];
    tf_cloth_accept(s, s->end, 1);
    ck_assert_int_eq(s->base.step, 1);
    ck_assert_int_eq(s->script_steps, 0);
    ck_assert_int_eq(tf_cloth_propose(s), TF_OK);
    ck_assert_double_eq(s->end[0], there);
    tf_cloth_accept(s, s->end, 0);
    ck_assert_int_eq(s->script_steps, 1);
    cloth_simulation_free(s);
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
    int two = 2, three = 3;
    tf_parallel on_two = scrambled_workers(&two),
                on_three = scrambled_workers(&three);
    tf_cloth_simulation *s[3];
    for (int i = 0; i < 3; i++)
        s[i] = cloth_of(shorts[_i].name, shorts[_i].size);
    for (int step = 0; step < shorts[_i].steps; step++) {
        simulate_step(s[0], NULL);
        simulate_step(s[1], &on_two);
        simulate_step(s[2], &on_three);
        expect_same(s[0], s[1]);
        expect_same(s[0], s[2]);
    }
    for (int i = 0; i < 3; i++)
        cloth_simulation_free(s[i]);
}
END_TEST

START_TEST(a_restored_snapshot_goes_on_bit_by_bit)
{
    tf_cloth_simulation *whole = cloth_of(shorts[_i].name, shorts[_i].size);
    tf_cloth_simulation *later = cloth_of(shorts[_i].name, shorts[_i].size);
    int half = shorts[_i].steps * 2 / 3;
    for (int step = 0; step < half; step++)
        simulate_step(whole, NULL);
    tf_snapshot state = tf_cloth_kind.snapshot(&whole->base);
    ck_assert_int_eq(tf_cloth_kind.restore(&later->base, &state), TF_OK);
    for (int step = half; step < shorts[_i].steps; step++) {
        simulate_step(whole, NULL);
        simulate_step(later, NULL);
    }
    expect_same(whole, later);
    cloth_simulation_free(whole);
    cloth_simulation_free(later);
}
END_TEST

// What a step reports -----------------------------------------------------------

static double ticks;

static double tick(void)
{
    return ticks++;
}

START_TEST(a_step_reports_what_it_took)
{
    tf_cloth_simulation *s = cloth_of("sphere", 10);
    tf_step_options options = {.check = true, .clock = tick};
    do {
        ck_assert_int_eq(tf_cloth_kind.step(&s->base, &options), TF_OK);
        ck_assert_double_eq(s->report.dynamics_seconds, 1);
        ck_assert_double_eq(s->report.response_seconds, 1);
        options.check = false;
    } while (s->report.response.first_contacts == 0);
    ck_assert_int_ge(s->report.response.rounds[TF_ZONES], 1);
    ck_assert_uint_ge(s->report.response.constraints,
                      s->report.response.first_contacts);
    const tf_body *body = &s->base.setup.body;
    ck_assert_double_eq(s->report.stretch, tf_body_stretch(body, s->position));
    ck_assert_double_eq(s->report.kinetic,
                        tf_body_kinetic_energy(body, s->velocity));
    ck_assert_double_eq(s->report.elastic,
                        tf_body_elastic_energy(body, s->position));
    cloth_simulation_free(s);
}
END_TEST

START_TEST(a_start_that_is_not_clear_is_no_step)
{
    tf_cloth_simulation *s = cloth_of("sphere", 10);
    tf_step_options options = {.check = true};
    s->position[2] -= 2;
    ck_assert_int_eq(tf_cloth_kind.step(&s->base, &options),
                     TF_START_NOT_CLEAR);
    ck_assert_int_eq(s->base.step, 0);
    cloth_simulation_free(s);
}
END_TEST

START_TEST(a_snapshot_of_other_cloth_is_refused)
{
    tf_cloth_simulation *coarse = cloth_of("sphere", 6);
    tf_cloth_simulation *fine = cloth_of("sphere", 7);
    simulate_step(coarse, NULL);
    tf_snapshot state = tf_cloth_kind.snapshot(&coarse->base);
    ck_assert_int_eq(tf_cloth_kind.restore(&fine->base, &state), TF_BAD_COUNT);
    ck_assert_int_eq(fine->base.step, 0);
    cloth_simulation_free(coarse);
    cloth_simulation_free(fine);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/cloth_simulation");
    TCase *steps = tcase_create("steps");
    tcase_add_test(steps, cloth_starts_at_rest);
    tcase_add_test(steps, unheld_cloth_falls_by_gravity);
    tcase_add_test(steps, velocities_lead_from_start_to_end);
    tcase_add_test(steps, the_script_waits_while_vertices_are_held);
    tcase_add_test(steps, a_step_reports_what_it_took);
    tcase_add_test(steps, a_start_that_is_not_clear_is_no_step);
    tcase_add_test(steps, a_snapshot_of_other_cloth_is_refused);
    suite_add_tcase(suite, steps);
    TCase *bits = tcase_create("bits");
    int some = (int)cases(sizeof shorts / sizeof *shorts);
    tcase_add_loop_test(bits, threads_change_nothing, 0, some);
    tcase_add_loop_test(bits, a_restored_snapshot_goes_on_bit_by_bit, 0, some);
    suite_add_tcase(suite, bits);
    return suite;
}
