// The scenes of flows begin with surfaces of good triangles.
#include "simulate/flow_scene.h"

#include "support/support.h"
#include "support/tangle.h"

#include <string.h>

static const tf_flow_scene *scene_of(int i)
{
    int count;
    const tf_flow_scene *all = tf_flow_scenes(&count);
    ck_assert_int_eq(count, 6);
    return &all[i];
}

START_TEST(scenes_are_found_by_name)
{
    const tf_flow_scene *scene = scene_of(_i);
    ck_assert_ptr_eq(tf_flow_scene_named(scene->name), scene);
    ck_assert_ptr_null(tf_flow_scene_named("sphere"));
}
END_TEST

START_TEST(scenes_are_embedded)
{
    const tf_flow_scene *scene = scene_of(_i);
    const double edges[] = {scene->edge, scene->most};
    for (int i = 0; i < 2; i++) {
        tf_body body = {.axes = 3};
        scene->build(&body, edges[i]);
        ck_assert(!body.failed);
        tf_mesh mesh = tf_body_mesh(&body);
        tangle_judge *judge = tangle_judge_new(&mesh);
        ck_assert_int_eq(tangle_count(judge, body.position), 0);
        tangle_judge_free(judge);
        tf_body_free(&body);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/flow_scene");
    TCase *tcase = tcase_create("scenes");
    tcase_add_loop_test(tcase, scenes_are_found_by_name, 0, 6);
    tcase_add_loop_test(tcase, scenes_are_embedded, 0, 6);
    suite_add_tcase(suite, tcase);
    return suite;
}
