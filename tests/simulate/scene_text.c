// Built-in scenes as texts: what is read back is the same scene.
#include "simulate/scene_text.h"

#include "simulate/cloth_scenes.h"
#include "simulate/filed_scene.h"
#include "simulate/flow_scenes.h"
#include "support/program.h"
#include "support/simulations.h"
#include "support/support.h"

#include <string.h>

static void expect_same(const tf_scene *found, const tf_scene *scene)
{
    ck_assert_ptr_eq(found->kind, scene->kind);
    ck_assert(found->build == scene->build);
    ck_assert(found->field == scene->field);
    ck_assert_int_eq(found->plane, scene->plane);
    ck_assert_int_eq(found->keep_topology, scene->keep_topology);
    ck_assert(found->steps == scene->steps && found->step == scene->step);
    ck_assert(found->gravity == scene->gravity &&
              found->friction == scene->friction);
    ck_assert_mem_eq(&found->material, &scene->material,
                     sizeof scene->material);
    ck_assert(found->air.drag == scene->air.drag &&
              found->air.veer == scene->air.veer &&
              found->air.gust == scene->air.gust);
    ck_assert_mem_eq(found->air.wind, scene->air.wind, sizeof scene->air.wind);
}

static void expect_read_back(const tf_scene *scene)
{
    tf_filed_scene filed;
    FILE *file = fopen("scene.yaml", "w");
    tf_scene_write(file, scene);
    fclose(file);
    ck_assert_msg(tf_filed_scene_read(&filed, "scene.yaml"), "%s",
                  filed.fault.text);
    ck_assert_double_eq(filed.resolution, scene->resolution.usual);
    ck_assert_str_eq(filed.meshes.physics.shows, scene->shows);
    ck_assert_str_eq(filed.meshes.physics.shape, scene->name);
    expect_same(&filed.scene, scene);
    tf_filed_scene_free(&filed);
}

START_TEST(every_scene_is_read_back)
{
    for (const tf_scene *s = tf_cloth_scenes; s->name; s++)
        expect_read_back(s);
    for (const tf_scene *s = tf_flow_scenes; s->name; s++)
        expect_read_back(s);
}
END_TEST

// Numbers that no scene has.
START_TEST(every_number_is_read_back)
{
    tf_scene scene = tf_cloth_scenes[0];
    scene.steps = 0;
    scene.step = 1.0 / 3;
    scene.gravity = 0x1.fffffffffffffp1023;
    scene.friction = 0x1p-1074;
    scene.air = (tf_air){.drag = 1.0 / 7,
                         .wind = {-1.0 / 9, 0, 0x1p-1022},
                         .veer = -2.0 / 3,
                         .gust = 1e-5};
    scene.material = (tf_material){0.1 + 0.2, 1e22, 0};
    expect_read_back(&scene);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/scene_text");
    TCase *tcase = tcase_create("texts");
    tcase_add_checked_fixture(tcase, enter_folder, leave_folder);
    tcase_add_test(tcase, every_scene_is_read_back);
    tcase_add_test(tcase, every_number_is_read_back);
    suite_add_tcase(suite, tcase);
    return suite;
}
