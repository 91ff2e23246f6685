// What simulations of any kind have in common, by a kind that does nothing.
#include "simulate/simulation.h"

#include "support/support.h"

static tf_status begun;
static int ends;

static tf_status begin(tf_simulation *simulation)
{
    ck_assert_int_eq(simulation->setup.body.vertices, 1);
    return begun;
}

static void end(tf_simulation *simulation)
{
    ck_assert_ptr_nonnull(simulation->scene);
    ends++;
}

static const tf_simulation_kind idle = {
    .size = sizeof(tf_simulation), .begin = begin, .end = end};

static void build(tf_scene_setup *setup, double resolution)
{
    tf_body_add_vertex(&setup->body, (const double[]){resolution, 0, 0});
}

static void build_without_memory(tf_scene_setup *setup, double resolution)
{
    (void)resolution;
    setup->body.failed = true;
}

START_TEST(a_simulation_begins_with_its_stage)
{
    const tf_scene scene = {
        .kind = &idle, .step = 0.25, .plane = _i, .build = build};
    tf_simulation *s = NULL;
    ends = 0;
    begun = TF_OK;
    ck_assert_int_eq(tf_simulation_create(&scene, 7, &s), TF_OK);
    ck_assert_ptr_eq(s->scene, &scene);
    ck_assert_double_eq(s->resolution, 7);
    ck_assert_int_eq(s->setup.body.axes, _i ? 2 : 3);
    ck_assert_double_eq(s->setup.body.position[0], 7);
    ck_assert_int_eq(s->step, 0);
    tf_simulation_go_to(s, 3);
    ck_assert_int_eq(s->step, 3);
    ck_assert_double_eq(s->time, 0.75);
    ck_assert_int_eq(ends, 0);
    tf_simulation_free(s);
    ck_assert_int_eq(ends, 1);
    tf_simulation_free(NULL);
    ck_assert_int_eq(ends, 1);
}
END_TEST

START_TEST(a_kind_that_cannot_begin_ends)
{
    const tf_scene scene = {.kind = &idle, .build = build};
    tf_simulation *s = NULL;
    ends = 0;
    begun = TF_NOT_EMBEDDED;
    ck_assert_int_eq(tf_simulation_create(&scene, 7, &s), TF_NOT_EMBEDDED);
    ck_assert_ptr_null(s);
    ck_assert_int_eq(ends, 1);
}
END_TEST

START_TEST(a_stage_without_memory_is_no_simulation)
{
    const tf_scene scene = {.kind = &idle, .build = build_without_memory};
    tf_simulation *s = NULL;
    ck_assert_int_eq(tf_simulation_create(&scene, 7, &s), TF_OUT_OF_MEMORY);
    ck_assert_ptr_null(s);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/simulation");
    TCase *tcase = tcase_create("simulations");
    tcase_add_loop_test(tcase, a_simulation_begins_with_its_stage, 0, 2);
    tcase_add_test(tcase, a_kind_that_cannot_begin_ends);
    tcase_add_test(tcase, a_stage_without_memory_is_no_simulation);
    suite_add_tcase(suite, tcase);
    return suite;
}
