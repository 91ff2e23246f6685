#define _GNU_SOURCE

#include "scenes/shown_frames.h"

#include "support/polydata.h"
#include "support/program.h"
#include "support/support.h"

#include <stdio.h>
#include <stdlib.h>

static tf_fault fault;

/// A text of a file with zeros in it.
static char *bytes_of(const char *path, size_t *size)
{
    char *text = malloc(100000);
    FILE *file = fopen(path, "rb");
    ck_assert_ptr_nonnull(file);
    *size = fread(text, 1, 99999, file);
    text[*size] = '\0';
    fclose(file);
    return text;
}

/// Two meshes in two frames, the second of which stays.
static tf_scene_meshes two_meshes(void)
{
    tf_scene_meshes meshes = {0};
    make_file("a0", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    make_file("a1", "v 0 0 5\nv 1 0 5\nv 0 1 5\nf 1 2 3\n");
    make_file("b0", "v 7 7 7\nv 8 8 8\nv 9 9 10\nv 7 8 9\nf 1 3 2\nl 4 1\n");
    tf_scene_mesh *mesh = tf_scene_meshes_add(&meshes);
    ck_assert(tf_frame_names_add(&mesh->frames, "a0"));
    ck_assert(tf_frame_names_add(&mesh->frames, "a1"));
    mesh = tf_scene_meshes_add(&meshes);
    ck_assert(tf_frame_names_add(&mesh->frames, "b0"));
    meshes.frames = 2;
    return meshes;
}

START_TEST(joined_meshes_are_shown)
{
    tf_scene_meshes meshes = two_meshes();
    tf_scene_frames frames = {.meshes = &meshes};
    tf_shown_frames shown;
    const tf_contact_points none = {0};
    ck_assert(tf_shown_frames_begin(&shown, "shown.pvd", &fault));
    for (int i = 0; i < 2; i++) {
        ck_assert_msg(tf_scene_frames_next(&frames), "%s", frames.fault.text);
        ck_assert(tf_shown_frames_add(&shown, &frames, &none));
    }
    ck_assert(tf_shown_frames_end(&shown));
    tf_shown_frames_free(&shown);
    size_t size;
    char *text = bytes_of("shown/mesh-00001.vtp", &size);
    static const double z[] = {5, 5, 5, 7, 8, 10, 9},
                        mesh[] = {0, 0, 0, 1, 1, 1, 1};
    static const double corner[] = {0, 1, 2, 3, 5, 4}, ends[] = {6, 3};
    for (size_t i = 0; i < 7; i++) {
        ck_assert(polydata_number(text, size, "Points", "Points", "Float64", 3,
                                  21, 3 * i + 2) == z[i]);
        ck_assert(polydata_number(text, size, "PointData", "mesh", "Int32", 1,
                                  7, i) == mesh[i]);
    }
    for (size_t i = 0; i < 6; i++)
        ck_assert(polydata_number(text, size, "Polys", "connectivity", "Int32",
                                  1, 6, i) == corner[i]);
    for (size_t i = 0; i < 2; i++)
        ck_assert(polydata_number(text, size, "Lines", "connectivity", "Int32",
                                  1, 2, i) == ends[i]);
    free(text);
    tf_scene_frames_free(&frames);
    tf_scene_meshes_free(&meshes);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("scenes/shown_frames");
    TCase *tcase = tcase_create("shown frames");
    tcase_add_checked_fixture(tcase, enter_folder, leave_folder);
    tcase_add_test(tcase, joined_meshes_are_shown);
    suite_add_tcase(suite, tcase);
    return suite;
}
