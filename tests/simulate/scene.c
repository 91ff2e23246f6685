#include "simulate/scene.h"

#include "support/support.h"

static const tf_scene list[] = {{.name = "one"}, {.name = "other"}, {0}};

START_TEST(a_name_finds_its_scene)
{
    ck_assert_ptr_eq(tf_scene_named(list, "one"), &list[0]);
    ck_assert_ptr_eq(tf_scene_named(list, "other"), &list[1]);
    ck_assert_ptr_null(tf_scene_named(list, ""));
    ck_assert_ptr_null(tf_scene_named(list, "ONE"));
    ck_assert_ptr_null(tf_scene_named(list, "onetime"));
    ck_assert_ptr_null(tf_scene_named(list + 2, "one"));
}
END_TEST

START_TEST(vertices_of_a_script_are_scripted)
{
    tf_scene_setup setup = {.body.axes = 3};
    for (int v = 0; v < 5; v++) {
        tf_body_add_vertex(&setup.body, (const double[]){v, 0, 0});
        setup.body.mass[v] = 1;
    }
    tf_scene_setup_add_script(&setup, (tf_script){.first = 1, .count = 1});
    tf_scene_setup_add_script(&setup,
                              (tf_script){.first = 3, .count = 2, .turn = 6});
    ck_assert_int_eq(setup.scripts, 2);
    ck_assert_int_eq(setup.script[0].first, 1);
    ck_assert_double_eq(setup.script[1].turn, 6);
    for (int v = 0; v < 5; v++)
        ck_assert_double_eq(setup.body.mass[v], v == 0 || v == 2);
    tf_body_free(&setup.body);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/scene");
    TCase *tcase = tcase_create("scenes");
    tcase_add_test(tcase, a_name_finds_its_scene);
    tcase_add_test(tcase, vertices_of_a_script_are_scripted);
    suite_add_tcase(suite, tcase);
    return suite;
}
