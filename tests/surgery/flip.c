// Flips of edges.
#include "surgery/flip.h"

#include "support/adaptive_surfaces.h"
#include "support/support.h"

static tf_outcome flip(tf_adaptive_surface *surface, int a, int b)
{
    tf_outcome outcome;
    ck_assert_int_eq(tf_adaptive_flip(surface, a, b, &outcome), TF_OK);
    return outcome;
}

START_TEST(an_edge_becomes_the_other_diagonal)
{
    tf_adaptive_surface *surface = adaptive_sheet(2, 2);
    ck_assert_int_eq(flip(surface, 0, 4), TF_COMMITTED);
    ck_assert(has_triangle(surface, 0, 1, 3));
    ck_assert(has_triangle(surface, 4, 3, 1));
    ck_assert_int_eq(triangles_of(surface), 8);
    ck_assert_int_eq(flip(surface, 1, 3), TF_COMMITTED); // and back
    ck_assert(has_triangle(surface, 0, 1, 4));
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(a_flip_needs_a_convex_quadrilateral)
{
    static double position[][3] = {
        {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.1, 0.1, 0}};
    static const int triangle[] = {0, 1, 3, 0, 3, 2};
    tf_adaptive_surface *surface = adaptive_of(4, position, 2, triangle);
    ck_assert_int_eq(flip(surface, 0, 3), TF_OVERLAPPED);
    tf_adaptive_free(surface);
}
END_TEST

// The edge is on the boundary, or no edge; or the other diagonal exists; or a
// ring of three would lose one.
START_TEST(flips_that_leave_no_surface_are_impossible)
{
    tf_adaptive_surface *surface = adaptive_sheet(2, 2);
    ck_assert_int_eq(flip(surface, 0, 1), TF_IMPOSSIBLE);
    ck_assert_int_eq(flip(surface, 0, 8), TF_IMPOSSIBLE);
    tf_adaptive_free(surface);
    surface = adaptive_tetrahedron();
    for (int i = 0; i < 16; i++)
        ck_assert_int_eq(flip(surface, i / 4, i % 4), TF_IMPOSSIBLE);
    tf_adaptive_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surgery/flip");
    TCase *tcase = tcase_create("flips");
    tcase_add_test(tcase, an_edge_becomes_the_other_diagonal);
    tcase_add_test(tcase, a_flip_needs_a_convex_quadrilateral);
    tcase_add_test(tcase, flips_that_leave_no_surface_are_impossible);
    suite_add_tcase(suite, tcase);
    return suite;
}
