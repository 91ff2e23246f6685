// The frames of the meshes of a scene, and the steps between them.
#define _GNU_SOURCE // strdup

#include "scenes/scene_frames.h"

#include "fast/detect.h"
#include "support/program.h"
#include "support/support.h"
#include "surface/check.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CORNERS "v 0 0 %g\nv 1 0 %g\nv 0 1 %g\nf 1 2 3\n"

/// A triangle at the height z.
static void make_triangle(const char *name, double z)
{
    char text[200];
    snprintf(text, sizeof text, CORNERS, z, z, z);
    make_file(name, text);
}

static void enter_folder_of_triangles(void)
{
    static const char *const names[] = {"0", "1", "2", "3", "4",
                                        "5", "6", "7", "8"};
    enter_folder();
    for (int z = 0; z < 9; z++)
        make_triangle(names[z], z);
}

/// Adds a mesh whose frames are called by the letters of a word.
static tf_scene_mesh *add(tf_scene_meshes *meshes, tf_role role,
                          const char *frames)
{
    tf_scene_mesh *mesh = tf_scene_meshes_add(meshes);
    mesh->role = role;
    for (const char *at = frames; *at; at++)
        ck_assert(tf_frame_names_add(&mesh->frames, (char[]){*at, 0}));
    return mesh;
}

static void free_both(tf_scene_frames *frames, tf_scene_meshes *meshes)
{
    tf_scene_frames_free(frames);
    tf_scene_meshes_free(meshes);
}

static void next(tf_scene_frames *frames)
{
    ck_assert_msg(tf_scene_frames_next(frames), "%s", frames->fault.text);
}

/// Expects the heights of three triangles at the start and the end of the step.
static void expect_heights(const tf_scene_frames *frames, const double start[3],
                           const double end[3])
{
    tf_motion motion = tf_scene_frames_motion(frames);
    ck_assert(motion.axes == 3 && motion.vertices == 9);
    for (int v = 0; v < 9; v++) {
        ck_assert(motion.start[3 * v] == (v % 3 == 1));
        ck_assert(motion.start[3 * v + 2] == start[v / 3]);
        ck_assert(motion.end[3 * v + 2] == end[v / 3]);
    }
    for (int m = 0; m < 3; m++)
        ck_assert(tf_scene_frames_positions(frames, m)[2] == end[m]);
}

#define HEIGHTS(...) ((const double[3]){__VA_ARGS__})

// Steps -----------------------------------------------------------------------

START_TEST(each_end_is_the_next_start)
{
    tf_scene_meshes meshes = {0};
    tf_scene_frames frames = {.meshes = &meshes};
    add(&meshes, TF_MOVING, "012");
    add(&meshes, TF_SCRIPTED, "345");
    add(&meshes, TF_FIXED, "78");
    next(&frames);
    expect_heights(&frames, HEIGHTS(0, 3, 7), HEIGHTS(0, 3, 7));
    const tf_surface *surface = frames.surface;
    next(&frames);
    expect_heights(&frames, HEIGHTS(0, 3, 7), HEIGHTS(1, 4, 7));
    next(&frames);
    expect_heights(&frames, HEIGHTS(1, 4, 7), HEIGHTS(2, 5, 7));
    ck_assert_ptr_eq(frames.surface, surface);
    ck_assert_str_eq(tf_scene_frames_file(&frames, 0, 0)->name, "1");
    ck_assert_str_eq(tf_scene_frames_file(&frames, 1, 1)->name, "5");
    ck_assert_str_eq(tf_scene_frames_file(&frames, 2, 1)->name, "7");
    free_both(&frames, &meshes);
}
END_TEST

START_TEST(what_was_changed_is_the_next_start)
{
    tf_scene_meshes meshes = {0};
    tf_scene_frames frames = {.meshes = &meshes};
    add(&meshes, TF_MOVING, "012");
    add(&meshes, TF_MOVING, "3");
    add(&meshes, TF_SCRIPTED, "7");
    next(&frames);
    next(&frames);
    expect_heights(&frames, HEIGHTS(0, 3, 7), HEIGHTS(1, 3, 7));
    for (int v = 0; v < 9; v++)
        tf_scene_frames_end(&frames)[3 * v + 2] += 0.5;
    tf_scene_frames_change(&frames);
    expect_heights(&frames, HEIGHTS(0, 3, 7), HEIGHTS(1.5, 3.5, 7.5));
    // A mesh of one frame stays where it is if it moves; the others go where
    // their frames have them.
    next(&frames);
    expect_heights(&frames, HEIGHTS(1.5, 3.5, 7.5), HEIGHTS(2, 3.5, 7));
    free_both(&frames, &meshes);
}
END_TEST

// A face with a corner that points inward is divided there; then another does.
START_TEST(changed_polygons_are_divided_anew)
{
    make_file("a", "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 1 2 3 4\n");
    tf_scene_meshes meshes = {0};
    tf_scene_frames frames = {.meshes = &meshes};
    add(&meshes, TF_SCRIPTED, "0");
    add(&meshes, TF_MOVING, "a");
    next(&frames);
    const tf_mesh_file *file = tf_scene_frames_file(&frames, 1, 1);
    int before[6];
    memcpy(before, file->triangle.item, sizeof before);
    double *x = tf_scene_frames_end(&frames) + 9;
    static const double moved[] = {4, 4, 0, 3, 1, 0};
    memcpy(x + 6, moved, sizeof moved);
    tf_scene_frames_change(&frames);
    ck_assert(tf_scene_frames_divide(&frames));
    ck_assert_int_ne(memcmp(before, file->triangle.item, sizeof before), 0);
    ck_assert(memcmp(file->position.item + 6, moved, sizeof moved) == 0);
    ck_assert(tf_scene_frames_positions(&frames, 1)[9] == 3);
    // The other mesh has a triangle, and this one a new diagonal.
    int edges;
    const int *edge = tf_surface_edges(frames.surface, &edges);
    ck_assert_int_eq(edges, 3 + 5);
    bool found = false;
    for (int i = 0; i < edges; i++)
        found = found || (edge[2 * i] == 4 && edge[2 * i + 1] == 6);
    ck_assert(found);
    free_both(&frames, &meshes);
}
END_TEST

START_TEST(what_follows_its_frames_has_no_inverse_mass)
{
    tf_scene_meshes meshes = {0};
    tf_scene_frames frames = {.meshes = &meshes};
    double inverse_mass[12];
    add(&meshes, TF_MOVING, "0")->mass = 0.5;
    add(&meshes, TF_SCRIPTED, "3");
    add(&meshes, TF_FIXED, "5");
    tf_scene_mesh *pinned = add(&meshes, TF_MOVING, "7");
    pinned->pinned = malloc(sizeof(int));
    pinned->pinned[0] = 1;
    pinned->pins = 1;
    next(&frames);
    ck_assert(tf_scene_frames_weigh(&frames, "a.yaml", inverse_mass));
    static const double right[12] = {6, 6, 6, 0, 0, 0, 0, 0, 0, 1, 0, 1};
    for (int v = 0; v < 12; v++)
        ck_assert_double_eq(inverse_mass[v], right[v]);
    meshes.mesh[3].pinned[0] = 3;
    meshes.mesh[3].name = strdup("last");
    ck_assert(!tf_scene_frames_weigh(&frames, "a.yaml", inverse_mass));
    ck_assert_str_eq(frames.fault.file, "a.yaml");
    expect_words(frames.fault.text, "'last' has no vertex 3; ");
    free_both(&frames, &meshes);
}
END_TEST

// In the plane ----------------------------------------------------------------

START_TEST(curves_make_a_curve_while_all_are_flat)
{
    make_file("a", "v 1 2\nv 3 4\nl 1 2\n");
    make_file("b", "v 5 6 -0\nv 7 8 0\nl 1 2\n");
    make_file("c", "v 5 6 0\nv 7 8 1\nl 1 2\n");
    tf_scene_meshes meshes = {0};
    tf_scene_frames frames = {.meshes = &meshes};
    add(&meshes, TF_FIXED, "a");
    add(&meshes, TF_MOVING, "bbcbb");
    static const int axes[] = {2, 2, 3, 3, 2};
    for (int i = 0; i < 5; i++) {
        next(&frames);
        tf_motion motion = tf_scene_frames_motion(&frames);
        ck_assert_int_eq(motion.axes, axes[i]);
        ck_assert_int_eq(tf_surface_axes(frames.surface), axes[i]);
        ck_assert(motion.end[axes[i]] == 3 && motion.end[2 * axes[i]] == 5);
        ck_assert(motion.start[2 * axes[i] + 1] == 6);
    }
    double *end = tf_scene_frames_end(&frames);
    end[4] = 50;
    tf_scene_frames_change(&frames);
    const double *x = tf_scene_frames_positions(&frames, 1);
    ck_assert(x[0] == 50 && x[1] == 6 && x[2] == 0 && signbit(x[2]));
    free_both(&frames, &meshes);
}
END_TEST

START_TEST(a_curve_beside_a_surface_is_in_space)
{
    make_file("a", "v 1 2\nv 3 4\nl 1 2\n");
    tf_scene_meshes meshes = {0};
    tf_scene_frames frames = {.meshes = &meshes};
    add(&meshes, TF_MOVING, "a");
    add(&meshes, TF_MOVING, "0");
    next(&frames);
    ck_assert_int_eq(tf_scene_frames_motion(&frames).axes, 3);
    free_both(&frames, &meshes);
}
END_TEST

// Pairs -----------------------------------------------------------------------

// Two triangles that cross, and a third that crosses both.
#define CROSSED                                                                \
    "v 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\n"                                     \
    "v 1 1 -1\nv 1 1 1\nv 5 5 1\nf 4 5 6\n"

/// How many intersections and contacts there are of meshes in these groups, which
/// rest.
static size_t intersections(bool each, int count, const char *const group[])
{
    make_file("x", CROSSED);
    make_file("y", CROSSED);
    tf_scene_meshes meshes = {0};
    tf_scene_frames frames = {.meshes = &meshes, .each = each};
    for (int i = 0; i < count; i++)
        add(&meshes, TF_MOVING, "x")->group =
            group[i] ? strdup(group[i]) : NULL;
    next(&frames);
    tf_motion rest = tf_scene_frames_motion(&frames);
    tf_crossings found;
    ck_assert(tf_surface_check(frames.surface, rest.vertices, rest.end, NULL,
                               &found, NULL) == TF_OK);
    tf_contacts contacts;
    ck_assert(tf_surface_detect(frames.surface, &rest, NULL, &contacts, NULL) ==
              TF_OK);
    size_t all = found.count + contacts.count;
    free_both(&frames, &meshes);
    return all;
}

START_TEST(meshes_of_a_group_do_not_meet)
{
    const char *const none[3] = {0}, *const two[] = {"a", NULL, "a"};
    const char *const all[] = {"a", "a", "a"}, *const other[] = {"a", "b",
                                                                 NULL};
    size_t alone = intersections(false, 1, none);
    size_t between = (intersections(false, 3, none) - 3 * alone) / 3;
    ck_assert(alone > 0 && between > 0);
    ck_assert_uint_eq(intersections(false, 3, none), 3 * alone + 3 * between);
    ck_assert_uint_eq(intersections(false, 3, two), 3 * alone + 2 * between);
    ck_assert_uint_eq(intersections(false, 3, all), 3 * alone);
    ck_assert_uint_eq(intersections(false, 3, other), 3 * alone + 3 * between);
    ck_assert_uint_eq(intersections(true, 3, two), 3 * alone);
}
END_TEST

// Faults ----------------------------------------------------------------------

START_TEST(other_elements_in_a_later_frame_are_refused)
{
    make_file("x", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 3 2\n");
    make_file("y", CROSSED);
    static const char *const frame[] = {"012x", "012y"};
    static const char *const fault[] = {
        "this triangle is not as in 2; all files must have the same elements "
        "in "
        "the same order",
        "6 vertices, but 2 has 3; all files must have the same "
        "elements"};
    for (int i = 0; i < 2; i++) {
        tf_scene_meshes meshes = {0};
        tf_scene_frames frames = {.meshes = &meshes};
        add(&meshes, TF_FIXED, "3");
        add(&meshes, TF_MOVING, frame[i]);
        for (int k = 0; k < 3; k++)
            next(&frames);
        ck_assert(!tf_scene_frames_next(&frames));
        ck_assert_str_eq(frames.fault.text, fault[i]);
        ck_assert_str_eq(frames.fault.file, i == 0 ? "x" : "y");
        ck_assert_int_eq(frames.fault.place, i == 0 ? 4 : -1);
        free_both(&frames, &meshes);
    }
}
END_TEST

START_TEST(flaws_are_those_of_a_file)
{
    make_file("x", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 2\n");
    make_file("y", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\n");
    make_file("z", "v 0 0 0\nv 1 0 0\nv 0 1 z\nf 1 2 3\n");
    static const char *const fault[] = {
        ("vertex 2 is a corner twice; delete the triangle or edge, here and in "
         "all files"),
        "there is no vertex 4; they are numbered from 1 to 3",
        "'z' is not a finite number; write a decimal or a hexadecimal float",
        "cannot open: No such file or directory; check the name"};
    static const long line[] = {5, 5, 3, -1};
    for (int i = 0; i < 4; i++) {
        tf_scene_meshes meshes = {0};
        tf_scene_frames frames = {.meshes = &meshes};
        const char name[] = {"xyz?"[i], '\0'};
        add(&meshes, TF_MOVING, "0");
        add(&meshes, TF_MOVING, name);
        add(&meshes, TF_MOVING, "1");
        ck_assert(!tf_scene_frames_next(&frames));
        ck_assert_str_eq(frames.fault.text, fault[i]);
        ck_assert_str_eq(frames.fault.file, name);
        ck_assert_int_eq(frames.fault.place, line[i]);
        free_both(&frames, &meshes);
    }
}
END_TEST

START_TEST(errors_of_pairs_name_the_files)
{
    static const struct {
        tf_error error;
        const char *fault, *file;
    } kinds[] = {
        {{.status = TF_START_NOT_CLEAR,
          .subject = TF_EDGE_TRIANGLE_PAIR,
          .vertex = {3, 5, 0, 1, 2}},
         "edge 0 2 passes through triangle 0 1 2 of 0 (numbered from 0) before "
         "the step begins; move them apart, see 'tanglefree check' for all "
         "such "
         "pairs",
         "2"},
        {{.status = TF_START_NOT_CLEAR,
          .subject = TF_POINT_TRIANGLE_PAIR,
          .vertex = {1, 3, 4, 5, -1}},
         "vertex 1 lies on triangle 0 1 2 of 2 (numbered from 0) before the "
         "step begins; move them apart, see 'tanglefree check' for all such "
         "pairs",
         "0"},
        {{.status = TF_START_NOT_CLEAR,
          .subject = TF_EDGE_EDGE_PAIR,
          .vertex = {0, 1, 4, 5, -1}},
         "edge 0 1 meets edge 1 2 of 2 (numbered from 0) before the step "
         "begins; move them apart, see 'tanglefree check' for all such pairs",
         "0"},
        {{.status = TF_START_NOT_CLEAR,
          .subject = TF_POINT_EDGE_PAIR,
          .vertex = {3, 0, 1, -1, -1}},
         "vertex 0 lies on edge 0 1 of 0 (numbered from 0) before the step "
         "begins; move them apart, see 'tanglefree check' for all such pairs",
         "2"},
        {{.status = TF_START_NOT_CLEAR,
          .subject = TF_EDGE_EDGE_PAIR,
          .vertex = {3, 4, 4, 5, -1}},
         "edge 0 1 meets edge 1 2 (numbered from 0) before the step begins; "
         "move them apart, see 'tanglefree check' for all such pairs",
         "2"},
        {{.status = TF_NOT_FINITE,
          .subject = TF_VERTEX,
          .index = 4,
          .vertex = {4, -1, -1, -1, -1}},
         NULL,
         "3"},
    };
    tf_scene_meshes meshes = {0};
    tf_scene_frames frames = {.meshes = &meshes};
    add(&meshes, TF_MOVING, "01");
    add(&meshes, TF_MOVING, "23");
    next(&frames);
    next(&frames);
    for (int i = 0; i < 6; i++) {
        ck_assert(!tf_scene_frames_fault(&frames, &kinds[i].error));
        ck_assert_str_eq(frames.fault.file, kinds[i].file);
        if (kinds[i].fault)
            ck_assert_str_eq(frames.fault.text, kinds[i].fault);
        ck_assert_int_eq(frames.fault.place, kinds[i].fault ? -1 : 2);
    }
    free_both(&frames, &meshes);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("scenes/scene_frames");
    TCase *steps = tcase_create("steps");
    tcase_add_checked_fixture(steps, enter_folder_of_triangles, leave_folder);
    tcase_add_test(steps, each_end_is_the_next_start);
    tcase_add_test(steps, what_was_changed_is_the_next_start);
    tcase_add_test(steps, changed_polygons_are_divided_anew);
    tcase_add_test(steps, what_follows_its_frames_has_no_inverse_mass);
    suite_add_tcase(suite, steps);

    TCase *plane = tcase_create("in the plane");
    tcase_add_checked_fixture(plane, enter_folder_of_triangles, leave_folder);
    tcase_add_test(plane, curves_make_a_curve_while_all_are_flat);
    tcase_add_test(plane, a_curve_beside_a_surface_is_in_space);
    suite_add_tcase(suite, plane);

    TCase *pairs = tcase_create("pairs");
    tcase_add_checked_fixture(pairs, enter_folder_of_triangles, leave_folder);
    tcase_add_test(pairs, meshes_of_a_group_do_not_meet);
    suite_add_tcase(suite, pairs);

    TCase *faults = tcase_create("faults");
    tcase_add_checked_fixture(faults, enter_folder_of_triangles, leave_folder);
    tcase_add_test(faults, other_elements_in_a_later_frame_are_refused);
    tcase_add_test(faults, flaws_are_those_of_a_file);
    tcase_add_test(faults, errors_of_pairs_name_the_files);
    suite_add_tcase(suite, faults);
    return suite;
}
