// The five tests: for each a witness that no other refuses, so that without it
// the surface would be spoilt.
#include "surgery/trial.h"

#include "experiments/leave_out.h"
#include "support/adaptive_surfaces.h"
#include "support/support.h"
#include "surgery/adaptive_surface.h"
#include "surgery/flip.h"
#include "surgery/move.h"
#include "surgery/split.h"

static tf_outcome move(tf_adaptive_surface *surface, int vertex, double x,
                       double y, double z)
{
    const double position[] = {x, y, z};
    tf_outcome outcome;
    ck_assert_int_eq(tf_adaptive_move(surface, vertex, position, &outcome),
                     TF_OK);
    return outcome;
}

static tf_outcome flip(tf_adaptive_surface *surface, int a, int b)
{
    tf_outcome outcome;
    ck_assert_int_eq(tf_adaptive_flip(surface, a, b, &outcome), TF_OK);
    return outcome;
}

// D: two triangles make a large one, whose corner 1 is on the line from 0 to 3.
START_TEST(D_refuses_a_flip_that_flattens_a_triangle)
{
    static double position[][3] = {{0, 0, 0}, {1, 1, 0}, {0, 2, 0}, {2, 2, 0}};
    static const int triangle[] = {0, 1, 2, 1, 3, 2};
    tf_adaptive_surface *surface = adaptive_of(4, position, 2, triangle);
    ck_assert_int_eq(flip(surface, 1, 2), TF_FLATTENED);
    leave_out(1U << TF_FLATTENED);
    ck_assert_int_eq(flip(surface, 1, 2), TF_COMMITTED);
    ck_assert(has_triangle(surface, 0, 1, 3));
    leave_out(0);
    tf_adaptive_free(surface);
}
END_TEST

/// A tetrahedron below a large triangle, whose edges are far away.
static tf_adaptive_surface *under_a_roof(void)
{
    static double position[][3] = {{0, 0, 0},  {1, 0, 0},   {0, 1, 0},
                                   {0, 0, 1},  {-9, -9, 2}, {20, -9, 2},
                                   {-9, 20, 2}};
    static const int triangle[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3, 4, 5, 6};
    return adaptive_of(7, position, 5, triangle);
}

// S: an edge is split, and the tip pierces a triangle.
START_TEST(S_refuses_a_split_that_pierces_a_triangle)
{
    static const double position[] = {0.25, 0.25, 3};
    tf_adaptive_surface *surface = under_a_roof();
    tf_outcome outcome;
    int vertex;
    for (int i = 0; i < 2; i++) {
        ck_assert_int_eq(
            tf_adaptive_split(surface, 1, 3, position, &vertex, &outcome),
            TF_OK);
        ck_assert_int_eq(outcome, i == 0 ? TF_OVERLAPPED : TF_COMMITTED);
        leave_out(1U << TF_OVERLAPPED);
    }
    leave_out(0);
    tf_adaptive_free(surface);
}
END_TEST

// V: a vertex moves far up, past a speck, which would be inside then.
START_TEST(V_refuses_a_move_that_swallows_a_speck)
{
    static double position[][3] = {{0, 0, 0},   {4, 0, 0},  {0, 4, 0},
                                   {0, 0, 4},   {3, 3, 2},  {3.1, 3, 2},
                                   {3, 3.1, 2}, {3, 3, 2.1}};
    static const int triangle[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3,
                                   4, 6, 5, 4, 5, 7, 5, 6, 7, 6, 4, 7};
    tf_adaptive_surface *surface = adaptive_of(8, position, 8, triangle);
    ck_assert_int_eq(move(surface, 3, 8, 8, 8), TF_PASSED_VERTEX);
    leave_out(1U << TF_PASSED_VERTEX);
    ck_assert_int_eq(move(surface, 3, 8, 8, 8), TF_COMMITTED);
    leave_out(0);
    tf_adaptive_free(surface);
}
END_TEST

// E: a corner passes an edge of its own tetrahedron, which turns inside out.
START_TEST(E_refuses_a_move_that_passes_an_edge)
{
    tf_adaptive_surface *surface = adaptive_tetrahedron();
    ck_assert_int_eq(move(surface, 0, 0.5, 0.5, -3), TF_PASSED_EDGE);
    leave_out(1U << TF_PASSED_EDGE);
    ck_assert_int_eq(move(surface, 0, 0.5, 0.5, -3), TF_COMMITTED);
    leave_out(0);
    tf_adaptive_free(surface);
}
END_TEST

// X: a corner passes through the face opposite, with the same result.
START_TEST(X_refuses_a_move_that_passes_a_triangle)
{
    tf_adaptive_surface *surface = adaptive_tetrahedron();
    ck_assert_int_eq(move(surface, 0, -2, -2, -2), TF_PASSED_TRIANGLE);
    leave_out(1U << TF_PASSED_TRIANGLE);
    ck_assert_int_eq(move(surface, 0, -2, -2, -2), TF_COMMITTED);
    leave_out(0);
    tf_adaptive_free(surface);
}
END_TEST

// At a boundary no triangle that is kept has the edges around the patch: the
// middle of a sheet of four squares passes vertices and edges there.
START_TEST(the_boundary_of_a_patch_is_an_obstacle)
{
    tf_adaptive_surface *surface = adaptive_sheet(2, 2);
    ck_assert_int_eq(move(surface, 4, 3, 1, 0), TF_OVERLAPPED);
    ck_assert_int_eq(move(surface, 4, 1, 1, 5), TF_COMMITTED);
    ck_assert_int_eq(move(surface, 4, 3, 3, 0), TF_OVERLAPPED);
    leave_out(1U << TF_OVERLAPPED);
    ck_assert_int_eq(move(surface, 4, 3, 3, 0), TF_PASSED_VERTEX);
    leave_out(1U << TF_OVERLAPPED | 1U << TF_PASSED_VERTEX);
    ck_assert_int_eq(move(surface, 4, 3, 3, -1), TF_PASSED_EDGE);
    leave_out(0);
    tf_adaptive_free(surface);
}
END_TEST

// To touch is to fail: by one unit in the last place it is done or refused.
START_TEST(touching_is_refused)
{
    tf_adaptive_surface *surface = under_a_roof();
    ck_assert_int_eq(move(surface, 3, 0, 0, 2), TF_OVERLAPPED);
    ck_assert_int_eq(move(surface, 3, 0, 0, 2 - 0x1p-52), TF_COMMITTED);
    tf_adaptive_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surgery/trial");
    TCase *tcase = tcase_create("witnesses");
    tcase_add_test(tcase, D_refuses_a_flip_that_flattens_a_triangle);
    tcase_add_test(tcase, S_refuses_a_split_that_pierces_a_triangle);
    tcase_add_test(tcase, V_refuses_a_move_that_swallows_a_speck);
    tcase_add_test(tcase, E_refuses_a_move_that_passes_an_edge);
    tcase_add_test(tcase, X_refuses_a_move_that_passes_a_triangle);
    tcase_add_test(tcase, the_boundary_of_a_patch_is_an_obstacle);
    tcase_add_test(tcase, touching_is_refused);
    suite_add_tcase(suite, tcase);
    return suite;
}
