// Pinches of loops of three edges.
#include "topology/pinch.h"

#include "experiments/leave_out.h"
#include "support/adaptive_surfaces.h"
#include "support/blobs.h"
#include "support/support.h"
#include "surgery/star.h"

#include <string.h>

static blobs made;

/// Five rings of three vertices, the middle one narrow.
static void make_neck(void)
{
    static const double radius[] = {1, 1, 0.3, 1, 1},
                        height[] = {0, 1, 2, 3, 4};
    made.vertices = made.triangles = 0;
    add_turned(&made, 3, 5, radius, height);
}

/// Adds a tetrahedron that is small.
static void add_speck(double x, double y, double z, double size)
{
    int v = made.vertices;
    const double position[4][3] = {
        {x, y, z}, {x + size, y, z}, {x, y + size, z}, {x, y, z + size}};
    static const int triangle[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
    memcpy(made.position[v], position, sizeof position);
    for (int i = 0; i < 12; i++)
        made.triangle[3 * made.triangles + i] = v + triangle[i];
    made.vertices += 4;
    made.triangles += 4;
}

/// The loop of the middle ring, with the upper part to its left, or with the
/// lower; its new vertices go up or down by so much.
static tf_outcome pinch(tf_adaptive_surface *surface, bool down, double by,
                        int vertex[3])
{
    const int up_loop[] = {6, 7, 8}, down_loop[] = {6, 8, 7};
    const int *loop = down ? down_loop : up_loop;
    double position[9];
    for (int i = 0; i < 9; i++)
        position[i] =
            coordinates_of(surface, loop[i / 3])[i % 3] + (i % 3 == 2) * by;
    tf_outcome outcome;
    ck_assert_int_eq(
        tf_adaptive_pinch(surface, loop, position, vertex, &outcome), TF_OK);
    return outcome;
}

START_TEST(a_pinch_makes_two_components)
{
    int vertex[3];
    make_neck();
    for (int down = 0; down < 2; down++) {
        tf_adaptive_surface *surface = blobs_surface(&made);
        int before = triangles_of(surface);
        double by = down ? -0.25 : 0.25;
        ck_assert_int_eq(pinch(surface, down, by, vertex), TF_COMMITTED);
        ck_assert_int_eq(parts_of(surface), 2);
        ck_assert_int_eq(euler_of(surface), 4);
        ck_assert_int_eq(triangles_of(surface), before + 2);
        ck_assert(is_sound(surface));
        ck_assert_double_eq(coordinates_of(surface, vertex[0])[2], 2 + by);
        ck_assert(has_triangle(surface, 6, down ? 8 : 7, down ? 7 : 8));
        ck_assert(has_triangle(surface, vertex[0], vertex[2], vertex[1]));
        tf_adaptive_free(surface);
    }
}
END_TEST

START_TEST(a_loop_that_is_left_alone_is_not_pinched)
{
    int vertex[3];
    make_neck();
    for (int v = 3; v < 9; v++) {
        tf_adaptive_surface *surface = blobs_surface(&made);
        adaptive_freeze(surface, v);
        ck_assert_int_eq(pinch(surface, false, 0.25, vertex),
                         v < 6 ? TF_COMMITTED : TF_IMPOSSIBLE);
        tf_adaptive_free(surface);
    }
}
END_TEST

// What is in the neck would be outside.
START_TEST(a_pinch_that_lets_a_speck_out_is_refused)
{
    int vertex[3];
    make_neck();
    add_speck(0, 0, 2.1, 0.02);
    tf_adaptive_surface *surface = blobs_surface(&made);
    ck_assert_int_eq(pinch(surface, false, 0.25, vertex), TF_PASSED_VERTEX);
    ck_assert_int_eq(pinch(surface, false, 0.05, vertex), TF_COMMITTED);
    tf_adaptive_free(surface);
    surface = blobs_surface(&made);
    leave_out(1U << TF_PASSED_VERTEX);
    ck_assert_int_eq(pinch(surface, false, 0.25, vertex), TF_COMMITTED);
    leave_out(0);
    tf_adaptive_free(surface);
}
END_TEST

// Something goes through the neck.
START_TEST(a_pinch_through_a_speck_is_refused)
{
    int vertex[3];
    make_neck();
    add_speck(0, 0, 1.9, 0.12);
    tf_adaptive_surface *surface = blobs_surface(&made);
    ck_assert_int_eq(pinch(surface, false, 0.25, vertex), TF_OVERLAPPED);
    ck_assert_int_eq(pinch(surface, true, -0.25, vertex), TF_OVERLAPPED);
    tf_adaptive_free(surface);
}
END_TEST

// The left side moves out of its own part, beyond a speck outside.
START_TEST(a_pinch_that_sweeps_over_a_speck_is_refused)
{
    int vertex[3];
    make_neck();
    add_speck(0.5, 0, 2.08, 0.02);
    tf_adaptive_surface *surface = blobs_surface(&made);
    double position[9];
    const int loop[] = {6, 7, 8};
    for (int i = 0; i < 9; i++)
        position[i] = coordinates_of(surface, 6 + i / 3)[i % 3] +
                      (i % 3 == 2 ? 0.1 : 0) + (i == 0 ? 0.5 : 0);
    tf_outcome outcome;
    ck_assert_int_eq(
        tf_adaptive_pinch(surface, loop, position, vertex, &outcome), TF_OK);
    ck_assert_int_eq(outcome, TF_PASSED_VERTEX);
    tf_adaptive_free(surface);
}
END_TEST

// The tip of a part may not pass the other side of its own.
START_TEST(a_pinch_that_turns_a_tip_inside_out_is_refused)
{
    static double position[][3] = {{1, 0, 0}, {-1, 1, 0},   {-1, -1, 0},
                                   {0, 0, 1}, {0.1, 0, -1}, {-0.1, 0, -3}};
    static const int triangle[] = {0, 1, 3, 1, 2, 3, 2, 0, 3, 1, 0, 4,
                                   4, 0, 2, 1, 4, 5, 4, 2, 5, 2, 1, 5};
    tf_adaptive_surface *surface = adaptive_of(6, position, 8, triangle);
    const int loop[] = {0, 1, 2};
    double up[9];
    int vertex[3];
    tf_outcome outcome;
    for (int i = 0; i < 9; i++)
        up[i] = position[i / 3][i % 3] + (i % 3 == 2 ? 3 : 0);
    ck_assert_int_eq(tf_adaptive_pinch(surface, loop, up, vertex, &outcome),
                     TF_OK);
    ck_assert_int_ne(outcome, TF_COMMITTED);
    for (int i = 2; i < 9; i += 3)
        up[i] = 0.2;
    ck_assert_int_eq(tf_adaptive_pinch(surface, loop, up, vertex, &outcome),
                     TF_OK);
    ck_assert_int_eq(outcome, TF_COMMITTED);
    ck_assert_int_eq(parts_of(surface), 2);
    tf_adaptive_free(surface);
}
END_TEST

// A ring with a hole of three edges: it is closed, and the ring is a ball.
START_TEST(a_pinch_closes_a_hole)
{
    static const double at[3] = {0};
    made.vertices = made.triangles = 0;
    add_ring(&made, at, 1, 0.4, 3, 3);
    tf_adaptive_surface *surface = blobs_surface(&made);
    ck_assert_int_eq(euler_of(surface), 0);
    const int loop[] = {1, 4, 7}; // the inner ones
    double position[9];
    int vertex[3];
    tf_outcome outcome;
    for (int i = 0; i < 9; i++)
        position[i] =
            coordinates_of(surface, loop[i / 3])[i % 3] +
            0.1 * (i % 3 == 2 ? -1 : 1) *
                (i % 3 == 2 ? 1 : coordinates_of(surface, loop[i / 3])[i % 3]);
    ck_assert_int_eq(
        tf_adaptive_pinch(surface, loop, position, vertex, &outcome), TF_OK);
    if (outcome != TF_COMMITTED) { // the other side
        const int back[] = {1, 7, 4};
        for (int i = 0; i < 9; i++)
            position[i] =
                coordinates_of(surface, back[i / 3])[i % 3] +
                0.1 * (i % 3 == 2
                           ? -1
                           : coordinates_of(surface, back[i / 3])[i % 3]);
        ck_assert_int_eq(
            tf_adaptive_pinch(surface, back, position, vertex, &outcome),
            TF_OK);
    }
    ck_assert_int_eq(outcome, TF_COMMITTED);
    ck_assert_int_eq(parts_of(surface), 1);
    ck_assert_int_eq(euler_of(surface), 2);
    ck_assert(is_sound(surface));
    tf_adaptive_free(surface);
}
END_TEST

static tf_outcome try_loop(tf_adaptive_surface *surface, int a, int b, int c)
{
    static const double position[9] = {9, 9, 9, 9, 9, 8, 9, 8, 8};
    int vertex[3];
    tf_outcome outcome;
    ck_assert_int_eq(tf_adaptive_pinch(surface, (const int[]){a, b, c},
                                       position, vertex, &outcome),
                     TF_OK);
    return outcome;
}

// A triangle; no edge; the same vertex; on the boundary.
START_TEST(pinches_that_leave_no_surface_are_impossible)
{
    make_neck();
    tf_adaptive_surface *surface = blobs_surface(&made);
    ck_assert_int_eq(try_loop(surface, 6, 7, 4), TF_IMPOSSIBLE);
    ck_assert_int_eq(try_loop(surface, 0, 1, 15), TF_IMPOSSIBLE);
    ck_assert_int_eq(try_loop(surface, 1, 0, 15), TF_IMPOSSIBLE);
    ck_assert_int_eq(try_loop(surface, 6, 7, 0), TF_IMPOSSIBLE);
    ck_assert_int_eq(try_loop(surface, 6, 7, 7), TF_IMPOSSIBLE);
    ck_assert_int_eq(try_loop(surface, 6, 6, 7), TF_IMPOSSIBLE);
    tf_adaptive_free(surface);
    made.triangles -= 6; // without its ends, the first ring is the boundary
    surface = blobs_surface(&made);
    ck_assert_int_eq(try_loop(surface, 0, 1, 2), TF_IMPOSSIBLE);
    ck_assert_int_eq(try_loop(surface, 2, 1, 0), TF_IMPOSSIBLE);
    tf_adaptive_free(surface);
}
END_TEST

// The triangle of 6, 9 and 10 is missing, above the loop; its other edges are
// whole.
START_TEST(a_loop_beside_a_gap_is_not_pinched)
{
    make_neck();
    for (int t = 0; t < made.triangles; t++) {
        int *v = made.triangle + 3 * t;
        if (v[0] != 6 || v[1] != 10 || v[2] != 9)
            continue;
        memcpy(v, made.triangle + 3 * --made.triangles, 3 * sizeof *v);
        break;
    }
    tf_adaptive_surface *surface = blobs_surface(&made);
    ck_assert_int_eq(try_loop(surface, 6, 7, 8), TF_IMPOSSIBLE);
    ck_assert_int_eq(try_loop(surface, 6, 8, 7), TF_IMPOSSIBLE);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(invalid_requests_are_rejected)
{
    int vertex[3];
    double position[9] = {0};
    tf_outcome outcome;
    make_neck();
    tf_adaptive_surface *surface = blobs_surface(&made);
    const int bad[] = {6, 7, 99}, good[] = {6, 7, 8};
    ck_assert_int_eq(
        tf_adaptive_pinch(surface, bad, position, vertex, &outcome),
        TF_BAD_INDEX);
    position[8] = 1 / position[0];
    ck_assert_int_eq(
        tf_adaptive_pinch(surface, good, position, vertex, &outcome),
        TF_NOT_FINITE);
    tf_adaptive_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("topology/pinch");
    TCase *tcase = tcase_create("pinches");
    tcase_add_test(tcase, a_pinch_makes_two_components);
    tcase_add_test(tcase, a_loop_that_is_left_alone_is_not_pinched);
    tcase_add_test(tcase, a_pinch_that_lets_a_speck_out_is_refused);
    tcase_add_test(tcase, a_pinch_through_a_speck_is_refused);
    tcase_add_test(tcase, a_pinch_that_sweeps_over_a_speck_is_refused);
    tcase_add_test(tcase, a_pinch_that_turns_a_tip_inside_out_is_refused);
    tcase_add_test(tcase, a_pinch_closes_a_hole);
    tcase_add_test(tcase, pinches_that_leave_no_surface_are_impossible);
    tcase_add_test(tcase, a_loop_beside_a_gap_is_not_pinched);
    tcase_add_test(tcase, invalid_requests_are_rejected);
    suite_add_tcase(suite, tcase);
    return suite;
}
