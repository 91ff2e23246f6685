// Collapses of edges.
#include "surgery/collapse.h"

#include "support/adaptive_surfaces.h"
#include "support/support.h"

#include <string.h>

static tf_outcome collapse(tf_adaptive_surface *surface, int from, int to)
{
    tf_outcome outcome;
    ck_assert_int_eq(tf_adaptive_collapse(surface, from, to, &outcome), TF_OK);
    return outcome;
}

static tf_outcome collapse_to(tf_adaptive_surface *surface, int from, int to,
                              double x, double y, double z)
{
    const double position[] = {x, y, z};
    tf_outcome outcome;
    ck_assert_int_eq(
        tf_adaptive_collapse_to(surface, from, to, position, &outcome), TF_OK);
    return outcome;
}

START_TEST(the_triangles_on_the_edge_vanish)
{
    tf_adaptive_surface *surface = adaptive_sheet(2, 2);
    ck_assert_int_eq(collapse(surface, 4, 8), TF_COMMITTED);
    ck_assert_int_eq(triangles_of(surface), 6);
    ck_assert(has_triangle(surface, 0, 1, 8));
    ck_assert(has_triangle(surface, 8, 7, 3));
    ck_assert(has_triangle(surface, 8, 1, 5));
    tf_adaptive_free(surface);
}
END_TEST

// On the boundary along it, from the inside to it, but not from it inwards, nor
// across.
START_TEST(the_boundary_collapses_only_along_itself)
{
    tf_adaptive_surface *surface = adaptive_sheet(2, 2);
    ck_assert_int_eq(collapse(surface, 1, 4), TF_IMPOSSIBLE);
    ck_assert_int_eq(collapse(surface, 1, 3), TF_IMPOSSIBLE); // no edge
    ck_assert_int_eq(collapse(surface, 1, 1), TF_IMPOSSIBLE);
    ck_assert_int_eq(collapse(surface, 1, 0), TF_COMMITTED);
    ck_assert_int_eq(triangles_of(surface), 7);
    tf_adaptive_free(surface);

    surface = adaptive_sheet(2, 1);
    ck_assert_int_eq(collapse(surface, 1, 5), TF_IMPOSSIBLE);
    tf_adaptive_free(surface);
}
END_TEST

// No surface of fewer than four triangles is closed.  Of two on a boundary all
// around either may vanish, but the other then must not move, nor vanish.
START_TEST(the_last_triangles_do_not_collapse)
{
    tf_adaptive_surface *surface = adaptive_tetrahedron();
    ck_assert_int_eq(collapse(surface, 0, 1), TF_IMPOSSIBLE);
    tf_adaptive_free(surface);
    surface = adaptive_sheet(1, 1);
    ck_assert_int_eq(collapse(surface, 0, 1), TF_IMPOSSIBLE);
    ck_assert_int_eq(collapse(surface, 1, 0), TF_COMMITTED);
    ck_assert(has_triangle(surface, 0, 3, 2));
    for (int i = 0; i < 16; i++)
        ck_assert_int_eq(collapse(surface, i / 4, i % 4), TF_IMPOSSIBLE);
    tf_adaptive_free(surface);
}
END_TEST

// A double pyramid over a triangle: its tips can move to the middle, and then
// no edge can collapse.
START_TEST(an_edge_in_a_ring_of_three_does_not_collapse)
{
    static double position[][3] = {
        {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    static const int triangle[] = {0, 1, 3, 1, 2, 3, 2, 0, 3,
                                   1, 0, 4, 2, 1, 4, 0, 2, 4};
    tf_adaptive_surface *surface = adaptive_of(5, position, 6, triangle);
    ck_assert_int_eq(collapse(surface, 0, 1), TF_IMPOSSIBLE);
    ck_assert_int_eq(collapse(surface, 3, 0), TF_COMMITTED);
    ck_assert_int_eq(triangles_of(surface), 4);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(an_edge_collapses_to_a_position)
{
    tf_adaptive_surface *surface = adaptive_sheet(3, 3);
    ck_assert_int_eq(collapse_to(surface, 5, 6, 1.5, 1, 0.5), TF_COMMITTED);
    ck_assert_int_eq(triangles_of(surface), 16);
    ck_assert_double_eq(coordinates_of(surface, 6)[0], 1.5);
    tf_adaptive_free(surface);
}
END_TEST

// The move of 6 is legal, but then 5 passes over itself: all is as before.
START_TEST(a_refused_collapse_undoes_its_move)
{
    tf_adaptive_surface *surface = adaptive_sheet(3, 3);
    double before[48];
    memcpy(before, tf_adaptive_positions(surface), sizeof before);
    ck_assert_int_eq(collapse_to(surface, 1, 6, 2, 1, 0.5), TF_IMPOSSIBLE);
    ck_assert_mem_eq(tf_adaptive_positions(surface), before, sizeof before);
    ck_assert_int_eq(triangles_of(surface), 18);
    tf_adaptive_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surgery/collapse");
    TCase *tcase = tcase_create("collapses");
    tcase_add_test(tcase, the_triangles_on_the_edge_vanish);
    tcase_add_test(tcase, the_boundary_collapses_only_along_itself);
    tcase_add_test(tcase, the_last_triangles_do_not_collapse);
    tcase_add_test(tcase, an_edge_in_a_ring_of_three_does_not_collapse);
    tcase_add_test(tcase, an_edge_collapses_to_a_position);
    tcase_add_test(tcase, a_refused_collapse_undoes_its_move);
    suite_add_tcase(suite, tcase);
    return suite;
}
