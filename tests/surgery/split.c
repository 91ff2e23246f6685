// Splits of edges.
#include "surgery/split.h"

#include "support/adaptive_surfaces.h"
#include "support/support.h"

static tf_outcome split(tf_adaptive_surface *surface, int a, int b, double x,
                        double y, double z, int *vertex)
{
    const double position[] = {x, y, z};
    tf_outcome outcome;
    *vertex = -1;
    ck_assert_int_eq(
        tf_adaptive_split(surface, a, b, position, vertex, &outcome), TF_OK);
    ck_assert(outcome == TF_COMMITTED || *vertex == -1);
    return outcome;
}

START_TEST(an_inner_edge_splits_two_triangles)
{
    tf_adaptive_surface *surface = adaptive_tetrahedron();
    int vertex;
    ck_assert_int_eq(split(surface, 0, 1, 2, 0.1, 0, &vertex), TF_COMMITTED);
    ck_assert_int_eq(vertex, 4);
    ck_assert_int_eq(triangles_of(surface), 6);
    ck_assert(has_triangle(surface, 0, 4, 2));
    ck_assert(has_triangle(surface, 4, 1, 2));
    ck_assert(has_triangle(surface, 1, 4, 3));
    ck_assert(has_triangle(surface, 4, 0, 3));
    ck_assert_double_eq(coordinates_of(surface, 4)[1], 0.1);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(a_boundary_edge_splits_one_triangle)
{
    tf_adaptive_surface *surface = adaptive_sheet(2, 2);
    int vertex;
    ck_assert_int_eq(split(surface, 1, 0, 0.5, 0, 0, &vertex), TF_COMMITTED);
    ck_assert_int_eq(triangles_of(surface), 9);
    ck_assert(has_triangle(surface, 0, 9, 4));
    ck_assert(has_triangle(surface, 9, 1, 4));
    tf_adaptive_free(surface);
}
END_TEST

// In the plane of the sheet: inside, on an edge, and beyond.
START_TEST(a_flat_split_stays_in_its_two_triangles)
{
    tf_adaptive_surface *surface = adaptive_sheet(2, 2);
    int vertex;
    ck_assert_int_eq(split(surface, 4, 5, 1.5, 2, 0, &vertex), TF_OVERLAPPED);
    ck_assert_int_eq(split(surface, 4, 5, 1.5, 1.5, 0, &vertex), TF_FLATTENED);
    ck_assert_int_eq(split(surface, 4, 5, 1.5, 1.25, 0, &vertex), TF_COMMITTED);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(a_split_needs_an_edge)
{
    tf_adaptive_surface *surface = adaptive_sheet(2, 2);
    int vertex;
    ck_assert_int_eq(split(surface, 0, 8, 1, 1, 1, &vertex), TF_IMPOSSIBLE);
    ck_assert_int_eq(split(surface, 3, 3, 1, 1, 1, &vertex), TF_IMPOSSIBLE);
    tf_adaptive_free(surface);
}
END_TEST

// In its own plane an isolated triangle could be turned over by no test's notice.
START_TEST(an_isolated_triangle_is_not_split)
{
    static double position[][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    static const int triangle[] = {0, 1, 2};
    tf_adaptive_surface *surface = adaptive_of(3, position, 1, triangle);
    int vertex;
    ck_assert_int_eq(split(surface, 0, 1, -0.5, 2.5, 0, &vertex),
                     TF_IMPOSSIBLE);
    tf_adaptive_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surgery/split");
    TCase *tcase = tcase_create("splits");
    tcase_add_test(tcase, an_inner_edge_splits_two_triangles);
    tcase_add_test(tcase, a_boundary_edge_splits_one_triangle);
    tcase_add_test(tcase, a_flat_split_stays_in_its_two_triangles);
    tcase_add_test(tcase, a_split_needs_an_edge);
    tcase_add_test(tcase, an_isolated_triangle_is_not_split);
    suite_add_tcase(suite, tcase);
    return suite;
}
