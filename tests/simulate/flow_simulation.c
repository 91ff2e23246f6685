// Scenes of flows, step by step, coarse, and judged.
#include "simulate/flow_simulation.h"

#include "simulate/flow_measures.h"
#include "support/flows.h"
#include "support/scrambled_workers.h"
#include "support/support.h"

#include <math.h>

static tf_flow_simulation *simulation_of(const char *name, double edge)
{
    tf_flow_simulation *made = NULL;
    ck_assert_int_eq(
        tf_flow_simulation_create(tf_flow_scene_named(name), edge, &made),
        TF_OK);
    return made;
}

static tf_flow_report step_of(tf_flow_simulation *s,
                              const tf_parallel *parallel)
{
    tf_step_way way = {.parallel = parallel};
    tf_flow_report report;
    ck_assert_int_eq(tf_flow_simulation_step(s, &way, &report), TF_OK);
    return report;
}

static const struct {
    const char *name;
    double edge;
    int steps, judged; ///< of so many steps one
} runs[] = {
    {"spheres", 0.05, 300, 10},  {"dumbbell", 0.04, 150, 5},
    {"enright", 0.045, 300, 20}, {"turbulence", 0.1, 150, 10},
    {"star", 0.06, 150, 10},     {"sheets", 0.1, 250, 10},
};

START_TEST(no_step_tangles)
{
    tf_flow_simulation *s = simulation_of(runs[_i].name, runs[_i].edge);
    while (s->step < runs[_i].steps) {
        step_of(s, NULL);
        if (s->step % runs[_i].judged == 0)
            expect_embedded(s->surface);
    }
    tf_flow_simulation_free(s);
}
END_TEST

START_TEST(workers_and_pauses_change_no_bit)
{
    static const int two = 2;
    tf_parallel parallel = scrambled_workers(&two);
    tf_flow_simulation *one = simulation_of("star", 0.06);
    tf_flow_simulation *other = simulation_of("star", 0.06);
    for (int i = 0; i < 80; i++) {
        step_of(one, NULL);
        step_of(other, &parallel);
        if (i % 7 == 0) {
            tf_mesh mesh = tf_adaptive_mesh(one->surface);
            ck_assert_int_eq(
                tf_flow_simulation_restore(other, one->step, &mesh,
                                           tf_adaptive_positions(one->surface)),
                TF_OK);
        }
    }
    tf_mesh mesh = tf_adaptive_mesh(one->surface);
    tf_mesh same = tf_adaptive_mesh(other->surface);
    ck_assert_int_eq(mesh.vertices, same.vertices);
    ck_assert_int_eq(mesh.triangles, same.triangles);
    ck_assert_mem_eq(mesh.triangle, same.triangle,
                     3 * sizeof(int) * (size_t)mesh.triangles);
    ck_assert_mem_eq(tf_adaptive_positions(one->surface),
                     tf_adaptive_positions(other->surface),
                     3 * sizeof(double) * (size_t)mesh.vertices);
    tf_flow_simulation_free(one);
    tf_flow_simulation_free(other);
}
END_TEST

START_TEST(what_is_restored)
{
    tf_flow_simulation *coarse = simulation_of("star", 0.1);
    tf_flow_simulation *fine = simulation_of("star", 0.06);
    tf_mesh mesh = tf_adaptive_mesh(coarse->surface);
    const double *position = tf_adaptive_positions(coarse->surface);
    ck_assert_int_eq(tf_flow_simulation_restore(fine, 7, &mesh, position),
                     TF_OK);
    ck_assert_int_eq(fine->step, 7);
    ck_assert_int_eq(tf_adaptive_mesh(fine->surface).triangles, mesh.triangles);
    mesh.triangles--;
    ((double *)position)[0] = NAN;
    ck_assert_int_eq(tf_flow_simulation_restore(fine, 8, &mesh, position),
                     TF_NOT_FINITE);
    ck_assert_int_eq(fine->step, 7);
    tf_flow_simulation_free(coarse);
    tf_flow_simulation_free(fine);
}
END_TEST

// The flow turns back, and would lead two balls to where they were.
START_TEST(what_has_merged_stays_one)
{
    tf_flow_simulation *s = simulation_of("spheres", 0.05);
    tf_flow_measures found;
    ck_assert(tf_flow_measure(s->surface, &found));
    ck_assert_int_eq(found.components, 2);
    double volume = found.volume, area = found.area;
    while (s->step < 300)
        step_of(s, NULL);
    ck_assert(tf_flow_measure(s->surface, &found));
    ck_assert_int_eq(found.components, 1);
    ck_assert_int_eq(found.genus, 0);
    ck_assert_double_eq_tol(found.volume, volume, 0.01 * volume);
    ck_assert_double_eq_tol(found.area, area, 0.05 * area);
    tf_flow_simulation_free(s);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/flow_simulation");
    TCase *tcase = tcase_create("scenes");
    tcase_add_loop_test(tcase, no_step_tangles, 0, sizeof runs / sizeof *runs);
    tcase_add_test(tcase, workers_and_pauses_change_no_bit);
    tcase_add_test(tcase, what_is_restored);
    tcase_add_test(tcase, what_has_merged_stays_one);
    suite_add_tcase(suite, tcase);
    return suite;
}
