#include "simulate/scene.h"

#include "support/simulations.h"
#include "support/support.h"

#include <string.h>

START_TEST(a_name_finds_its_scene)
{
    for (int i = 0; i < scene_count(); i++)
        ck_assert_ptr_eq(tf_scene_named(scene_number(i)->name),
                         scene_number(i));
    ck_assert_ptr_null(tf_scene_named(""));
    ck_assert_ptr_null(tf_scene_named("list"));
    ck_assert_ptr_null(tf_scene_named("SPHERE"));
}
END_TEST

START_TEST(every_scene_is_complete)
{
    ck_assert_int_eq(scene_count(), 7);
    for (int i = 0; i < scene_count(); i++) {
        const tf_scene *scene = scene_number(i);
        ck_assert_uint_gt(strlen(scene->shows), 10);
        ck_assert_uint_gt(strlen(scene->size_means), 10);
        ck_assert_int_ge(scene->size, scene->least);
        ck_assert_int_gt(scene->least, 0);
        ck_assert_int_gt(scene->steps, 100);
        ck_assert_double_gt(scene->step, 0);
        ck_assert(scene->build);
    }
}
END_TEST

// Each scene's size, from the smallest on.
START_TEST(every_scene_starts_clear)
{
    const tf_scene *scene = scene_number(_i);
    int sizes[] = {scene->least, scene->least + 1, scene->least + 2,
                   scene->size, scene->size * 3 / 2};
    for (int i = 0; i < cases(5); i++) {
        tf_stage stage;
        tf_scene_build(scene, sizes[i], &stage);
        ck_assert(!stage.body.failed);
        ck_assert_int_gt(stage.body.elastics, 0);
        expect_clear(&stage.body);
        tf_body_free(&stage.body);
    }
}
END_TEST

START_TEST(handles_are_scripted)
{
    const tf_scene *scene = scene_number(_i);
    tf_stage stage;
    tf_scene_build(scene, scene->least, &stage);
    int loose = 0;
    for (int v = 0; v < stage.body.vertices; v++)
        loose += stage.body.mass[v] > 0;
    ck_assert_int_gt(loose, 0);
    for (int h = 0; h < stage.handles; h++) {
        const tf_handle *handle = &stage.handle[h];
        ck_assert_int_gt(handle->count, 0);
        for (int i = 0; i < handle->count; i++)
            ck_assert_double_eq(stage.body.mass[handle->first + i], 0);
        ck_assert_double_lt(handle->end, scene->steps * scene->step);
    }
    tf_body_free(&stage.body);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/scene");
    TCase *tcase = tcase_create("scenes");
    tcase_add_test(tcase, a_name_finds_its_scene);
    tcase_add_test(tcase, every_scene_is_complete);
    tcase_add_loop_test(tcase, every_scene_starts_clear, 0, scene_count());
    tcase_add_loop_test(tcase, handles_are_scripted, 0, scene_count());
    suite_add_tcase(suite, tcase);
    return suite;
}
