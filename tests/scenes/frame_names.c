// Which files a scene means by a name or a pattern.
#include "scenes/frame_names.h"

#include "support/program.h"
#include "support/support.h"

#include <string.h>
#include <unistd.h>

static void enter_folder_of_frames(void)
{
    enter_folder();
    run("mkdir walk 'w[1]' && cd walk && touch body1.obj body2.obj body10.obj "
        "'a*b' axb 'a?b' other.ply && cd ../w* && touch x1 x2");
}

/// Expects that a name in a scene means these files, divided by blanks.
static void expect_names(const char *scene, const char *name, const char *right)
{
    tf_frame_names names = {0};
    char all[300] = "";
    tf_names_found found = tf_frame_names_find(&names, scene, name);
    for (int i = 0; i < names.count; i++) {
        strcat(all, i > 0 ? " " : "");
        strcat(all, names.path[i]);
    }
    ck_assert_str_eq(all, right);
    ck_assert_int_eq(found, *right ? TF_NAMES_ADDED : TF_NAMES_NONE);
    tf_frame_names_free(&names);
    ck_assert(!names.path && names.count == 0);
}

START_TEST(names_are_relative_to_the_scene)
{
    expect_names("scene.yaml", "walk/body1.obj", "walk/body1.obj");
    expect_names("walk/scene.yaml", "body1.obj", "walk/body1.obj");
    expect_names("./walk/scene.yaml", "../walk/body2.obj",
                 "./walk/../walk/body2.obj");
    expect_names("walk/scene.yaml", "walk/body1.obj", "");
    char here[300];
    ck_assert(getcwd(here, sizeof here - 10) != NULL);
    strcat(here, "/walk/axb");
    expect_names("nowhere/scene.yaml", here, here);
}
END_TEST

START_TEST(patterns_mean_files_in_natural_order)
{
    expect_names("walk/scene.yaml", "body*.obj",
                 "walk/body1.obj walk/body2.obj walk/body10.obj");
    expect_names("scene.yaml", "walk/body[0-9].obj",
                 "walk/body1.obj walk/body2.obj");
    expect_names("scene.yaml", "*/body?.obj", "walk/body1.obj walk/body2.obj");
    expect_names("scene.yaml", "walk/shirt*", "");
    expect_names("scene.yaml", "walk/body1", "");
}
END_TEST

START_TEST(a_file_of_that_name_is_no_pattern)
{
    expect_names("walk/scene.yaml", "a*b", "walk/a*b");
    expect_names("walk/scene.yaml", "a?b", "walk/a?b");
    expect_names("walk/scene.yaml", "a?[b]", "walk/a*b walk/a?b walk/axb");
}
END_TEST

START_TEST(the_folder_of_the_scene_is_no_pattern)
{
    expect_names("w[1]/scene.yaml", "x*", "w[1]/x1 w[1]/x2");
    run("mkdir w1 && touch w1/x7");
    expect_names("w[1]/scene.yaml", "x[0-9]", "w[1]/x1 w[1]/x2");
    run("mkdir 'b\\s*' && touch 'b\\s*/x1'");
    expect_names("b\\s*/scene.yaml", "x?", "b\\s*/x1");
}
END_TEST

START_TEST(names_are_added_behind_others)
{
    tf_frame_names names = {0};
    ck_assert(tf_frame_names_add(&names, "first"));
    ck_assert(tf_frame_names_find(&names, "walk/s.yaml", "body?.obj") ==
              TF_NAMES_ADDED);
    ck_assert_int_eq(names.count, 3);
    ck_assert_str_eq(names.path[0], "first");
    ck_assert_str_eq(names.path[2], "walk/body2.obj");
    tf_frame_names_free(&names);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("scenes/frame_names");
    TCase *names = tcase_create("names");
    tcase_add_checked_fixture(names, enter_folder_of_frames, leave_folder);
    tcase_add_test(names, names_are_relative_to_the_scene);
    tcase_add_test(names, patterns_mean_files_in_natural_order);
    tcase_add_test(names, a_file_of_that_name_is_no_pattern);
    tcase_add_test(names, the_folder_of_the_scene_is_no_pattern);
    tcase_add_test(names, names_are_added_behind_others);
    suite_add_tcase(suite, names);
    return suite;
}
