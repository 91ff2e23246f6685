// Scenes of flows, step by step, coarse, and judged.
#include "simulate/flow_simulation.h"

#include "simulate/flow_scenes.h"
#include "support/flows.h"
#include "support/scrambled_workers.h"
#include "support/support.h"

#include <math.h>

static tf_flow_simulation *flow_of(const char *name, double edge)
{
    tf_simulation *made = NULL;
    ck_assert_int_eq(
        tf_simulation_create(tf_scene_named(tf_flow_scenes, name), edge, &made),
        TF_OK);
    return (tf_flow_simulation *)made;
}

static void free_flow(tf_flow_simulation *f)
{
    tf_simulation_free(&f->base);
}

static void step_of(tf_flow_simulation *f, const tf_parallel *parallel)
{
    tf_step_options options = {.parallel = parallel};
    ck_assert_int_eq(tf_flow_kind.step(&f->base, &options), TF_OK);
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
    tf_flow_simulation *f = flow_of(runs[_i].name, runs[_i].edge);
    while (f->base.step < runs[_i].steps) {
        step_of(f, NULL);
        if (f->base.step % runs[_i].judged == 0)
            expect_embedded(f->surface);
    }
    free_flow(f);
}
END_TEST

static void expect_same(const tf_flow_simulation *one,
                        const tf_flow_simulation *other)
{
    tf_snapshot a = tf_flow_kind.snapshot(&one->base);
    tf_snapshot b = tf_flow_kind.snapshot(&other->base);
    ck_assert_int_eq(a.step, b.step);
    ck_assert_int_eq(a.mesh.vertices, b.mesh.vertices);
    ck_assert_int_eq(a.mesh.triangles, b.mesh.triangles);
    ck_assert_mem_eq(a.mesh.triangle, b.mesh.triangle,
                     3 * sizeof(int) * (size_t)a.mesh.triangles);
    ck_assert_mem_eq(a.position, b.position,
                     3 * sizeof(double) * (size_t)a.mesh.vertices);
}

START_TEST(workers_and_pauses_change_no_bit)
{
    static const int two = 2;
    tf_parallel parallel = scrambled_workers(&two);
    tf_flow_simulation *one = flow_of("star", 0.06);
    tf_flow_simulation *other = flow_of("star", 0.06);
    for (int i = 0; i < 80; i++) {
        step_of(one, NULL);
        step_of(other, &parallel);
        tf_snapshot state = tf_flow_kind.snapshot(&one->base);
        if (i % 7 == 0)
            ck_assert_int_eq(tf_flow_kind.restore(&other->base, &state), TF_OK);
    }
    expect_same(one, other);
    free_flow(one);
    free_flow(other);
}
END_TEST

START_TEST(a_snapshot_is_restored_or_changes_nothing)
{
    tf_flow_simulation *coarse = flow_of("star", 0.1);
    tf_flow_simulation *fine = flow_of("star", 0.06);
    tf_snapshot state = tf_flow_kind.snapshot(&coarse->base);
    state.step = 7;
    ck_assert_int_eq(tf_flow_kind.restore(&fine->base, &state), TF_OK);
    ck_assert_int_eq(fine->base.step, 7);
    tf_simulation_go_to(&coarse->base, 7);
    expect_same(fine, coarse);
    ck_assert_int_eq(fine->measures.triangles, state.mesh.triangles);
    state.step = 8;
    ((double *)state.position)[0] = NAN;
    ck_assert_int_eq(tf_flow_kind.restore(&fine->base, &state), TF_NOT_FINITE);
    ck_assert_int_eq(fine->base.step, 7);
    free_flow(coarse);
    free_flow(fine);
}
END_TEST

// The flow turns back, and would lead two balls to where they were.
START_TEST(merged_balls_stay_merged_when_the_flow_turns_back)
{
    tf_flow_simulation *f = flow_of("spheres", 0.05);
    ck_assert_int_eq(f->measures.components, 2);
    double volume = f->measures.volume, area = f->measures.area;
    while (f->base.step < 300)
        step_of(f, NULL);
    ck_assert_int_eq(f->measures.components, 1);
    ck_assert_int_eq(f->measures.genus, 0);
    ck_assert_double_eq_tol(f->measures.volume, volume, 0.01 * volume);
    ck_assert_double_eq_tol(f->measures.area, area, 0.05 * area);
    free_flow(f);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/flow_simulation");
    TCase *tcase = tcase_create("scenes");
    tcase_add_loop_test(tcase, no_step_tangles, 0, sizeof runs / sizeof *runs);
    tcase_add_test(tcase, workers_and_pauses_change_no_bit);
    tcase_add_test(tcase, a_snapshot_is_restored_or_changes_nothing);
    tcase_add_test(tcase, merged_balls_stay_merged_when_the_flow_turns_back);
    suite_add_tcase(suite, tcase);
    return suite;
}
