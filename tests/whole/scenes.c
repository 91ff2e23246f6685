// The scenes of the simulator: step by step free of tangles, by an independent
// judge; without response they tangle.
#include "support/simulations.h"
#include "support/support.h"

#include <math.h>
#include <stdio.h>

// Small, and long enough to meet itself or something.
static const struct {
    const char *name;
    int size, steps;
} shorts[] = {{"sphere", 12, 80},      {"stack", 8, 60},     {"twist", 4, 300},
              {"knot", 3, 300},        {"curtain", 12, 500}, {"flag", 8, 300},
              {"plane-chain", 60, 200}};

START_TEST(a_scene_stays_free_of_tangles)
{
    const char *name = shorts[_i].name;
    tf_cloth_simulation *c = cloth_of(name, shorts[_i].size);
    tangle_judge *judge = judge_of(&c->base.setup.body);
    double stretch = 1;
    size_t contacts = 0;
    for (int step = 0; step < shorts[_i].steps; step++) {
        tf_cloth_report report = simulate_step(c, NULL);
        contacts += report.response.first_contacts;
        int tangled = tangle_count(judge, c->position);
        ck_assert_msg(tangled == 0, "%s, step %d: %d, such as %s", name,
                      c->base.step, tangled, tangle_text(tangles(judge)));
        stretch = report.stretch > stretch ? report.stretch : stretch;
    }
    printf("%s: %d steps, %zu contacts, stretched to %g\n", name, c->base.step,
           contacts, stretch);
    ck_assert_uint_gt(contacts, 0);
    ck_assert_double_le(stretch, 1.15);
    tangle_judge_free(judge);
    cloth_simulation_free(c);
}
END_TEST

START_TEST(a_scene_without_response_tangles)
{
    const char *name = shorts[_i].name;
    tf_cloth_simulation *c = cloth_of(name, shorts[_i].size);
    tangle_judge *judge = judge_of(&c->base.setup.body);
    int tangled = 0;
    for (int step = 0; step < shorts[_i].steps; step++) {
        simulate_blindly(c);
        tangled += tangle_count(judge, c->position) > 0;
    }
    printf("%s: tangled after %d of %d steps\n", name, tangled, c->base.step);
    ck_assert_int_gt(tangled, 0);
    tangle_judge_free(judge);
    cloth_simulation_free(c);
}
END_TEST

// Energy ------------------------------------------------------------------------

/// Kinetic, elastic and potential energy.
static double energy_of(const tf_cloth_simulation *c)
{
    const tf_body *body = &c->base.setup.body;
    double sum = tf_body_kinetic_energy(body, c->velocity) +
                 tf_body_elastic_energy(body, c->position);
    for (int v = 0; v < body->vertices; v++)
        sum += body->mass[v] * c->base.scene->gravity *
               c->position[body->axes * v + body->axes - 1];
    return sum;
}

// Those without wind, as long as no script moves.
static const struct {
    const char *name;
    int size, steps;
} falls[] = {{"sphere", 16, 149}, {"stack", 8, 250}, {"plane-chain", 80, 400}};

// In a step that hits something, what the springs of twenty sweeps have not come
// to terms about may be gained.  It is never more than was there at first, and all
// of it together is little.
START_TEST(what_falls_gains_no_energy)
{
    tf_cloth_simulation *c = cloth_of(falls[_i].name, falls[_i].size);
    double first = energy_of(c), last = first, gain = 0;
    for (int step = 0; step < falls[_i].steps; step++) {
        simulate_step(c, NULL);
        double energy = energy_of(c);
        ck_assert_double_lt(energy, first);
        gain += fmax(0, energy - last);
        last = energy;
    }
    printf("%s: of %g J at first, %g are lost, and %g gained in all steps\n",
           falls[_i].name, first, first - last, gain);
    fflush(stdout);
    ck_assert_double_le(gain, 0.05 * (first - last));
    cloth_simulation_free(c);
}
END_TEST

// Rest --------------------------------------------------------------------------

/// The kinetic energy after a step of free fall from rest.
static double fall_of(const tf_cloth_simulation *c)
{
    const tf_body *body = &c->base.setup.body;
    double speed = c->base.scene->gravity * c->base.scene->step, sum = 0;
    for (int v = 0; v < body->vertices; v++)
        sum += body->mass[v] / 2 * speed * speed;
    return sum;
}

START_TEST(a_stack_comes_to_rest)
{
    enum {
        FALL = 150,
        STEPS = 250
    };
    tf_cloth_simulation *c = cloth_of("stack", 10);
    double sum = 0;
    int grouped = 0;
    for (int step = 0; step < STEPS; step++) {
        tf_cloth_report report = simulate_step(c, NULL);
        sum += step < FALL ? 0 : report.kinetic;
        grouped += report.response.grouped > 0;
    }
    double mean = sum / (STEPS - FALL), fall = fall_of(c);
    printf("stack: %g J at rest, and %g after a step of free fall\n", mean,
           fall);
    fflush(stdout);
    ck_assert_double_le(mean, 0.05 * fall);
    ck_assert_int_le(grouped, STEPS / 100);
    cloth_simulation_free(c);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/scenes");
    TCase *tcase = tcase_create("scenes");
    int scenes = (int)cases(sizeof shorts / sizeof *shorts);
    tcase_add_loop_test(tcase, a_scene_stays_free_of_tangles, 0, scenes);
    tcase_add_loop_test(tcase, a_scene_without_response_tangles, 0, scenes);
    suite_add_tcase(suite, tcase);
    tcase = tcase_create("energy");
    tcase_add_loop_test(tcase, what_falls_gains_no_energy, 0,
                        (int)(sizeof falls / sizeof *falls));
    tcase_add_test(tcase, a_stack_comes_to_rest);
    suite_add_tcase(suite, tcase);
    return suite;
}
