// The folder for the frames of a scene: what is in it, and what stays.

#include "scenes/scene_folder.h"

#include "support/program.h"
#include "support/support.h"

#include <stdio.h>
#include <string.h>

#define MESH "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"

static tf_scene_meshes meshes;
static tf_scene_frames frames;

static void add(const char *name, tf_role role, int count)
{
    tf_scene_mesh *mesh = tf_scene_meshes_add(&meshes);
    mesh->role = role;
    for (int i = 0; i < count; i++)
        ck_assert(tf_frame_names_add(&mesh->frames, name));
}

/// A body that goes on, and a shirt that moves.
static void enter_folder_with_scene(void)
{
    enter_folder();
    make_file("body.obj", MESH);
    make_file("shirt.obj", "# mine\n" MESH);
    meshes = (tf_scene_meshes){.frames = 2};
    frames = (tf_scene_frames){.meshes = &meshes, .keeps_sources = true};
    add("body.obj", TF_SCRIPTED, 2);
    add("shirt.obj", TF_MOVING, 2);
    ck_assert(tf_scene_meshes_name(&meshes));
    ck_assert(tf_scene_frames_next(&frames));
}

static void leave_folder_with_scene(void)
{
    tf_scene_frames_free(&frames);
    tf_scene_meshes_free(&meshes);
    leave_folder();
}

static void begin(tf_scene_folder *folder)
{
    ck_assert_msg(tf_scene_folder_begin(folder, "made", "", &frames.fault),
                  "%s", frames.fault.text);
}

START_TEST(meshes_that_move_are_written)
{
    tf_scene_folder folder = {0};
    begin(&folder);
    double *x = tf_scene_frames_end(&frames);
    x[9] = 7;
    ck_assert(tf_scene_folder_write(&folder, &frames));
    ck_assert_str_eq(run("ls made").out, "shirt-00000.obj\n");
    const char *text = file_text("made/shirt-00000.obj");
    ck_assert_str_eq(text, "# mine\nv 7 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    ck_assert(folder.bytes == (double)strlen(text));
}
END_TEST

START_TEST(what_was_held_back_is_written_and_told)
{
    tf_scene_folder folder = {0};
    begin(&folder);
    ck_assert(tf_scene_frames_next(&frames));
    double *x = tf_scene_frames_end(&frames);
    x[2] = 0.5;
    ck_assert_ptr_nonnull(freopen("told", "w", stderr));
    ck_assert(tf_scene_folder_write(&folder, &frames));
    fflush(stderr);
    ck_assert_str_eq(run("ls made").out, "body-00001.obj\nshirt-00001.obj\n");
    ck_assert_str_eq(file_text("told"),
                     "tanglefree: body was held back in frame 1; "
                     "made/body-00001.obj has its actual positions\n");
}
END_TEST

START_TEST(frames_are_kept_or_deleted)
{
    tf_scene_folder folder = {0};
    begin(&folder);
    ck_assert(tf_scene_folder_write(&folder, &frames));
    ck_assert_ptr_nonnull(freopen("told", "w", stderr));
    tf_scene_folder_leave(&folder, &frames, true);
    fflush(stderr);
    ck_assert_str_eq(run("ls made").out, "shirt-00000.obj\n");
    expect_words(file_text("told"),
                 "tanglefree: made has the frames before that; ");
    tf_scene_folder_leave(&folder, &frames, false);
    ck_assert_int_ne(run("ls made").status, 0);
}
END_TEST

// Nothing that was there is deleted with what was made.
START_TEST(what_was_not_begun_is_left_alone)
{
    tf_scene_folder folder = {0};
    run("mkdir made && touch made/shirt-00000.obj");
    ck_assert(!tf_scene_folder_begin(&folder, "made", "", &frames.fault));
    ck_assert_str_eq(frames.fault.file, "made");
    expect_words(frames.fault.text, "exists, and is not an empty folder");
    tf_scene_folder_leave(&folder, &frames, false);
    ck_assert_str_eq(run("ls made").out, "shirt-00000.obj\n");
}
END_TEST

START_TEST(a_mesh_is_no_folder)
{
    tf_scene_folder folder = {0};
    ck_assert(
        !tf_scene_folder_begin(&folder, "made.ply", ", or not", &frames.fault));
    ck_assert_str_eq(frames.fault.text, "the frames of a scene need a folder; "
                                        "leave out .ply, or not");
    ck_assert_int_ne(run("ls made.ply").status, 0);
}
END_TEST

START_TEST(something_must_move)
{
    tf_fault fault = {0};
    ck_assert(tf_scene_check_moving(&meshes, "a.yaml", "resolve", &fault));
    meshes.mesh[1].role = TF_FIXED;
    ck_assert(!tf_scene_check_moving(&meshes, "a.yaml", "resolve", &fault));
    ck_assert_str_eq(fault.file, "a.yaml");
    ck_assert_str_eq(fault.text, "no mesh is moving, so there is nothing to "
                                 "resolve; let one be, by its role");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("scenes/scene_folder");
    TCase *tcase = tcase_create("folders");
    tcase_add_checked_fixture(tcase, enter_folder_with_scene,
                              leave_folder_with_scene);
    tcase_add_test(tcase, meshes_that_move_are_written);
    tcase_add_test(tcase, what_was_held_back_is_written_and_told);
    tcase_add_test(tcase, frames_are_kept_or_deleted);
    tcase_add_test(tcase, what_was_not_begun_is_left_alone);
    tcase_add_test(tcase, a_mesh_is_no_folder);
    tcase_add_test(tcase, something_must_move);
    suite_add_tcase(suite, tcase);
    return suite;
}
