// Hints at vertices that coincide, where these are why elements touch.
#define _GNU_SOURCE // strdup
#include "scenes/seams.h"

#include "support/program.h"
#include "support/support.h"

#include <stdio.h>
#include <string.h>

#define TRIANGLE "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
#define SEAM TRIANGLE "v 1 0 0\nv 1 1 0\nv 0 1 0\nf 4 5 6\n"
#define NEEDLE "v 0.2 0.2 -1\nv 0.2 0.2 1\nl -1 -2\n"

/// Checks a scene of these texts, and returns what is said of it, twice if
/// `again`.
static const char *hints(int meshes, const char *const text[], bool again)
{
    static const char *names[] = {"a", "b", "c"};
    bool hinted[3] = {false};
    tf_scene_meshes all = {0};
    tf_scene_frames frames = {.meshes = &all};
    for (int i = 0; i < meshes; i++) {
        make_file(names[i], text[i]);
        ck_assert(
            tf_frame_names_add(&tf_scene_meshes_add(&all)->frames, names[i]));
    }
    ck_assert(tf_scene_frames_next(&frames));
    tf_motion rest = tf_scene_frames_motion(&frames);
    tf_crossings found;
    ck_assert(tf_surface_check(frames.surface, rest.vertices, rest.end, NULL,
                               &found, NULL) == TF_OK);
    ck_assert(freopen("err", "w", stderr) != NULL);
    for (int i = 0; i < (again ? 2 : 1); i++)
        tf_hint_at_seams(&frames, &found, names, hinted);
    fflush(stderr);
    tf_scene_frames_free(&frames);
    tf_scene_meshes_free(&all);
    return file_text("err");
}

START_TEST(seams_are_hinted_at)
{
    const char *said = hints(1, (const char *[]){SEAM}, true);
    ck_assert_str_eq(
        said, "tanglefree: a: 11 of 11 intersections are between elements with "
              "corners at the same position, as at an unwelded seam; 2 "
              "vertices coincide with others, which 'tanglefree weld' joins\n");
    said = hints(1, (const char *[]){SEAM NEEDLE}, false);
    expect_words(said, "tanglefree: a: 11 of 12 intersections are");
    said =
        hints(1, (const char *[]){TRIANGLE "v 0 0 0\nv 0 0 9\nl 4 5\n"}, false);
    expect_words(said, "; 1 vertex coincides with others, which ");
}
END_TEST

START_TEST(other_intersections_are_not)
{
    ck_assert_str_eq(hints(1, (const char *[]){TRIANGLE NEEDLE}, false), "");
    ck_assert_str_eq(
        hints(1, (const char *[]){TRIANGLE NEEDLE "v 5 5 5\nv 5 5 5\n"}, false),
        "");
    ck_assert_str_eq(hints(2, (const char *[]){TRIANGLE, TRIANGLE}, false), "");
}
END_TEST

START_TEST(each_mesh_has_its_hint)
{
    const char *said =
        hints(3, (const char *[]){SEAM, TRIANGLE NEEDLE, SEAM}, true);
    ck_assert_int_eq(occurrences(said, "\n"), 2);
    expect_words(said, "tanglefree: a: 11 of 11 ");
    expect_words(said, "tanglefree: c: 11 of 11 ");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("scenes/seams");
    TCase *hints = tcase_create("hints");
    tcase_add_checked_fixture(hints, enter_folder, leave_folder);
    tcase_add_test(hints, seams_are_hinted_at);
    tcase_add_test(hints, other_intersections_are_not);
    tcase_add_test(hints, each_mesh_has_its_hint);
    suite_add_tcase(suite, hints);
    return suite;
}
