// Notes on frames: what is written is read, and what others write says nothing.
#include "simulate/frame_notes.h"

#include "support/program.h"
#include "support/support.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/// A PLY header with these lines, and the same line behind it.
static void make_header(const char *lines)
{
    char text[1000];
    snprintf(text, sizeof text, "ply\nformat ascii 1.0\n%send_header\n%s",
             lines, lines);
    make_file("frame.ply", text);
}

static tf_frame_notes notes_of(const char *lines)
{
    tf_frame_notes notes;
    make_header(lines);
    ck_assert(tf_frame_notes_read(&notes, "frame.ply"));
    return notes;
}

START_TEST(notes_are_lines_of_text)
{
    tf_scene_mesh mesh[] = {{.name = "shirt"},
                            {.name = "a\nb: c", .role = TF_SCRIPTED},
                            {.name = "floor", .role = TF_FIXED}};
    tf_scene_meshes meshes = {.mesh = mesh, .count = 3, .physics.up = 1};
    const tf_joined joined = {3, (int[]){0, 2, 5, 6}, NULL, NULL};
    char *text = tf_frame_notes_write(&meshes, &joined);
    ck_assert_str_eq(text, "up y\nmesh of 2 vertices, moving: shirt\n"
                           "mesh of 3 vertices, scripted: a\\x0ab: c\n"
                           "mesh of 1 vertices, fixed: floor");
    free(text);
    meshes.physics.up = -1;
    meshes.count = 0;
    text = tf_frame_notes_write(&meshes, &joined);
    ck_assert_str_eq(text, "up z");
    free(text);
}
END_TEST

START_TEST(notes_are_read)
{
    tf_frame_notes notes = notes_of("comment up y\n"
                                    "comment mesh of 2 vertices, moving: a\n"
                                    "element vertex 6\n"
                                    "comment mesh of 3 vertices, scripted: b\n"
                                    "comment mesh of 1 vertices, fixed: c\n");
    ck_assert_int_eq(notes.up, 1);
    ck_assert_int_eq(notes.meshes, 3);
    static const int end[] = {2, 5, 6};
    for (int m = 0; m < 3; m++)
        ck_assert_int_eq(notes.mesh[m].end, end[m]);
    static const tf_role role[] = {TF_MOVING,   TF_MOVING,   TF_SCRIPTED,
                                   TF_SCRIPTED, TF_SCRIPTED, TF_FIXED,
                                   TF_MOVING};
    for (int v = 0; v < 7; v++)
        ck_assert_int_eq(tf_frame_notes_role(&notes, v), role[v]);
    tf_frame_notes_free(&notes);
    ck_assert_int_eq(notes.meshes, 0);
}
END_TEST

START_TEST(what_others_write_says_nothing)
{
    static const char *const lines[] = {
        "",
        "comment up w\n",
        "comment upside down\n",
        "comment mesh of 3 vertices, asleep: a\n",
        "comment mesh of x vertices, fixed: a\n",
        "comment mesh of -3 vertices, fixed: a\n",
        "comment mesh of 3000000000 vertices, fixed: a\n",
        "up y\nmesh of 3 vertices, fixed: a\n"};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        tf_frame_notes notes = notes_of(lines[i]);
        ck_assert_msg(notes.up == -1 && notes.meshes == 0, "%s", lines[i]);
        tf_frame_notes_free(&notes);
    }
    tf_frame_notes notes =
        notes_of("comment mesh of 999999999 vertices, fixed: "
                 "a\ncomment mesh of 999999999 vertices, "
                 "fixed: b\ncomment mesh of 999999999 "
                 "vertices, fixed: c\n");
    ck_assert_int_eq(notes.meshes, 2);
    tf_frame_notes_free(&notes);
    make_file("frame.obj", "comment up y\nend_header\n");
    ck_assert(tf_frame_notes_read(&notes, "frame.obj") && notes.up == -1);
    ck_assert(tf_frame_notes_read(&notes, "no.ply") && notes.up == -1);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/frame_notes");
    TCase *notes = tcase_create("notes");
    tcase_add_unchecked_fixture(notes, enter_folder, leave_folder);
    tcase_add_test(notes, notes_are_lines_of_text);
    tcase_add_test(notes, notes_are_read);
    tcase_add_test(notes, what_others_write_says_nothing);
    suite_add_tcase(suite, notes);
    return suite;
}
