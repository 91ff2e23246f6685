// Merges of two edges.
#include "topology/merge.h"

#include "experiments/leave_out.h"
#include "support/adaptive_scenes.h"
#include "support/adaptive_surfaces.h"
#include "support/blobs.h"
#include "support/support.h"
#include "surgery/adaptive_surface.h"
#include "surgery/star.h"

#include <math.h>
#include <string.h>

static adaptive_scene scene;
static int exponent; ///< of the power of two by which all positions are scaled

/// Two boxes of unit squares, one above the other, and a speck between them if
/// it is wanted; the upper one is turned over, or not.
static tf_adaptive_surface *two_boxes(bool speck, bool turned)
{
    static const double corner[4][3] = {
        {0.5, 0.4, 1.5}, {0.6, 0.4, 1.5}, {0.5, 0.5, 1.5}, {0.5, 0.4, 1.6}};
    scene = (adaptive_scene){.unit = 1};
    add_box(&scene, (const int[]){0, 0, 0}, (const int[]){2, 2, 1});
    add_box(&scene, (const int[]){0, 0, 2}, (const int[]){2, 2, 3});
    if (turned)
        turn_part_over(&scene);
    if (speck)
        add_tetrahedron(&scene, corner);
    for (int i = 0; i < 3 * scene.vertices; i++)
        scene.position[i] = ldexp(scene.position[i], exponent);
    tf_mesh mesh = adaptive_scene_mesh(&scene);
    tf_adaptive_surface *made = NULL;
    ck_assert_int_eq(tf_adaptive_create(&mesh, scene.position, &made, NULL),
                     TF_OK);
    return made;
}

static int vertex_at(double x, double y, double z)
{
    const double at[] = {ldexp(x, exponent), ldexp(y, exponent),
                         ldexp(z, exponent)};
    for (int v = 0; v < scene.vertices; v++)
        if (memcmp(scene.position + 3 * (ptrdiff_t)v, at, sizeof at) == 0)
            return v;
    ck_abort_msg("no vertex there");
}

/// Merges the diagonals of the squares that face each other at 0 <= x, y <= 1.
static tf_outcome merge_diagonals(tf_adaptive_surface *surface)
{
    const int low[] = {vertex_at(0, 0, 1), vertex_at(1, 1, 1)};
    const int high[2][2] = {{vertex_at(0, 0, 2), vertex_at(1, 1, 2)},
                            {vertex_at(0, 1, 2), vertex_at(1, 0, 2)}};
    int way = tf_find_edge(surface, high[0][0], high[0][1]) == TF_NONE;
    tf_outcome outcome;
    ck_assert_int_eq(tf_adaptive_merge(surface, low, high[way], &outcome),
                     TF_OK);
    return outcome;
}

START_TEST(a_merge_joins_two_components)
{
    tf_adaptive_surface *surface = two_boxes(false, false);
    int before = triangles_of(surface);
    ck_assert_int_eq(parts_of(surface), 2);
    ck_assert_int_eq(merge_diagonals(surface), TF_COMMITTED);
    ck_assert_int_eq(triangles_of(surface), before + 4);
    ck_assert_int_eq(parts_of(surface), 1);
    ck_assert_int_eq(euler_of(surface), 2);
    ck_assert_double_eq_tol(volume_of(surface), 4 + 4 + 1, 1e-12);
    ck_assert(is_sound(surface));
    ck_assert_int_eq(merge_diagonals(surface), TF_IMPOSSIBLE); // it is gone
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(edges_that_are_left_alone_do_not_merge)
{
    for (int high = 0; high < 2; high++) {
        tf_adaptive_surface *surface = two_boxes(false, false);
        if (high) // whichever diagonal there is
            for (int i = 0; i < 4; i++)
                adaptive_freeze(surface, vertex_at(i / 2, i % 2, 2));
        else
            adaptive_freeze(surface, vertex_at(0, 0, 1));
        ck_assert_int_eq(merge_diagonals(surface),
                         high ? TF_IMPOSSIBLE : TF_COMMITTED);
        tf_adaptive_free(surface);
    }
    tf_adaptive_surface *surface = two_boxes(false, false);
    adaptive_freeze(surface, vertex_at(0, 0, 1));
    adaptive_freeze(surface, vertex_at(1, 1, 1));
    ck_assert_int_eq(merge_diagonals(surface), TF_IMPOSSIBLE);
    tf_adaptive_free(surface);
}
END_TEST

// The lengths of its diagonals must neither over- nor underflow.
START_TEST(a_merge_is_the_same_in_any_unit_of_length)
{
    exponent = 0;
    tf_adaptive_surface *one = two_boxes(false, false);
    ck_assert_int_eq(merge_diagonals(one), TF_COMMITTED);
    const tf_mesh *mesh = tf_adaptive_mesh(one);
    for (exponent = -1000; exponent <= 1000; exponent += 100) {
        tf_adaptive_surface *other = two_boxes(false, false);
        ck_assert_int_eq(merge_diagonals(other), TF_COMMITTED);
        ck_assert_int_eq(tf_adaptive_mesh(other)->triangles, mesh->triangles);
        ck_assert_mem_eq(tf_adaptive_mesh(other)->triangle, mesh->triangle,
                         3 * sizeof(int) * (size_t)mesh->triangles);
        tf_adaptive_free(other);
    }
    tf_adaptive_free(one);
}
END_TEST

// A speck between would be inside after that.
START_TEST(a_merge_around_a_speck_is_refused)
{
    tf_adaptive_surface *surface = two_boxes(true, false);
    ck_assert_int_eq(merge_diagonals(surface), TF_PASSED_VERTEX);
    leave_out(1U << TF_PASSED_VERTEX);
    ck_assert_int_eq(merge_diagonals(surface), TF_COMMITTED);
    leave_out(0);
    tf_adaptive_free(surface);
}
END_TEST

// An outer side does not fit to an inner one: the tube would cross itself.
START_TEST(a_front_does_not_merge_with_a_back)
{
    tf_adaptive_surface *surface = two_boxes(false, true);
    ck_assert_int_eq(merge_diagonals(surface), TF_OVERLAPPED);
    tf_adaptive_free(surface);
}
END_TEST

static tf_outcome merge(tf_adaptive_surface *surface, int a, int b, int c,
                        int d)
{
    tf_outcome outcome;
    ck_assert_int_eq(tf_adaptive_merge(surface, (const int[]){a, b},
                                       (const int[]){c, d}, &outcome),
                     TF_OK);
    return outcome;
}

// No edge; on the boundary; a common vertex; neighbors; a second edge between
// the same two triangles.
START_TEST(merges_that_leave_no_surface_are_impossible)
{
    tf_adaptive_surface *surface = adaptive_sheet(8, 2);
    ck_assert_int_eq(merge(surface, 0, 26, 13, 23), TF_IMPOSSIBLE);
    ck_assert_int_eq(merge(surface, 0, 1, 13, 23), TF_IMPOSSIBLE);
    ck_assert_int_eq(merge(surface, 0, 10, 10, 20), TF_IMPOSSIBLE);
    ck_assert_int_eq(merge(surface, 0, 10, 2, 12), TF_IMPOSSIBLE);
    ck_assert_int_eq(merge(surface, 0, 10, 0, 10), TF_IMPOSSIBLE);
    tf_adaptive_free(surface);
    static blobs made;
    for (int i = 0; i < 2; i++) {
        static const double radius[] = {1, 1, 1}, height[] = {0, 1, 2};
        int first = made.vertices;
        add_turned(&made, 3, 3, radius, height);
        for (int v = first; v < made.vertices; v++)
            made.position[v][0] += 2.2 * i;
    }
    // The vertex 9 below the first ring has three triangles.
    surface = blobs_surface(&made);
    ck_assert_int_eq(merge(surface, 9, 0, 14, 18), TF_IMPOSSIBLE);
    ck_assert_int_eq(merge(surface, 14, 18, 9, 0), TF_IMPOSSIBLE);
    tf_adaptive_free(surface);
}
END_TEST

// Two squares with a boundary, the upper of which looks down: what is left is a
// tube, with the same boundary.
START_TEST(a_merge_keeps_the_boundary)
{
    static double position[][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                   {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    static const int triangle[] = {0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6};
    tf_adaptive_surface *surface = adaptive_of(8, position, 4, triangle);
    ck_assert_int_eq(merge(surface, 0, 2, 4, 6), TF_COMMITTED);
    ck_assert_int_eq(triangles_of(surface), 8);
    ck_assert(is_sound(surface));
    for (int i = 0; i < 4; i++) {
        int c = tf_find_edge(surface, i, (i + 1) % 4);
        ck_assert_int_ne(c, TF_NONE);
        ck_assert(tf_is_boundary_edge(surface, c));
    }
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(invalid_requests_are_rejected)
{
    tf_adaptive_surface *surface = adaptive_sheet(3, 1);
    tf_outcome outcome;
    ck_assert_int_eq(tf_adaptive_merge(surface, (const int[]){0, 8},
                                       (const int[]){0, 5}, &outcome),
                     TF_BAD_INDEX);
    ck_assert_int_eq(tf_adaptive_merge(surface, (const int[]){0, 5},
                                       (const int[]){-1, 5}, &outcome),
                     TF_BAD_INDEX);
    tf_adaptive_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("topology/merge");
    TCase *tcase = tcase_create("merges");
    tcase_add_test(tcase, a_merge_joins_two_components);
    tcase_add_test(tcase, edges_that_are_left_alone_do_not_merge);
    tcase_add_test(tcase, a_merge_is_the_same_in_any_unit_of_length);
    tcase_add_test(tcase, a_merge_around_a_speck_is_refused);
    tcase_add_test(tcase, a_front_does_not_merge_with_a_back);
    tcase_add_test(tcase, merges_that_leave_no_surface_are_impossible);
    tcase_add_test(tcase, a_merge_keeps_the_boundary);
    tcase_add_test(tcase, invalid_requests_are_rejected);
    suite_add_tcase(suite, tcase);
    return suite;
}
