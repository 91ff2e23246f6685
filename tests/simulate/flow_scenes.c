// The scenes of flows begin with surfaces of good triangles.
#include "simulate/flow_scenes.h"

#include "simulate/flow_simulation.h"
#include "support/simulations.h"
#include "support/support.h"

#include <string.h>

START_TEST(every_scene_is_complete)
{
    const tf_scene *scene = &tf_flow_scenes[_i];
    ck_assert_ptr_eq(scene->kind, &tf_flow_kind);
    ck_assert_ptr_eq(tf_scene_named(tf_flow_scenes, scene->name), scene);
    ck_assert_ptr_null(tf_scene_named(tf_cloth_scenes, scene->name));
    ck_assert_uint_gt(strlen(scene->shows), 10);
    ck_assert_ptr_null(scene->resolution.counts);
    ck_assert_double_ge(scene->resolution.usual, scene->resolution.least);
    ck_assert_double_ge(scene->resolution.most, scene->resolution.usual);
    ck_assert_int_gt(scene->steps, 100);
    ck_assert_double_gt(scene->step, 0);
    ck_assert(scene->field);
}
END_TEST

START_TEST(every_scene_starts_embedded)
{
    const tf_resolution *range = &tf_flow_scenes[_i].resolution;
    const double edges[] = {range->usual, range->most};
    for (int i = 0; i < 2; i++) {
        tf_scene_setup setup = setup_of(&tf_flow_scenes[_i], edges[i]);
        tangle_judge *judge = judge_of(&setup.body);
        ck_assert_int_eq(tangle_count(judge, setup.body.position), 0);
        tangle_judge_free(judge);
        tf_body_free(&setup.body);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/flow_scenes");
    TCase *tcase = tcase_create("scenes");
    int scenes = scene_count(tf_flow_scenes);
    tcase_add_loop_test(tcase, every_scene_is_complete, 0, scenes);
    tcase_add_loop_test(tcase, every_scene_starts_embedded, 0, scenes);
    suite_add_tcase(suite, tcase);
    return suite;
}
