// What is next to what, of surfaces that one can count by hand.
#include "untangle/neighbors.h"

#include "support/support.h"
#include "support/surface_of.h"

#include <math.h>
#include <stdlib.h>

static tf_neighbors found;

static void find(tf_surface *surface)
{
    found = (tf_neighbors){.axes = 0};
    ck_assert(tf_neighbors_find(&found, surface));
}

// Three triangles at an edge, a rod, and a particle.
START_TEST(an_edge_may_have_three_triangles)
{
    static const int triangle[] = {0, 1, 2, 3, 1, 0, 0, 1, 4};
    static const int rod[] = {5, 6};
    tf_mesh mesh = {3, 8, 3, triangle, 1, rod};
    tf_surface *surface = surface_of(&mesh);
    find(surface);
    int edge = tf_edge_of(&found, 1, 0);
    ck_assert_int_eq(tf_list_length(&found.sides, edge), 3);
    ck_assert(!tf_is_boundary(&found, edge));
    ck_assert(tf_is_boundary(&found, tf_edge_of(&found, 0, 4)));
    ck_assert_int_eq(tf_edge_of(&found, 2, 3), -1);
    ck_assert_int_ge(tf_triangle_of(&found, 4, 0, 1), 0);
    ck_assert_int_eq(tf_triangle_of(&found, 4, 0, 2), -1);
    ck_assert_int_eq(tf_list_length(&found.around, 0), 4);
    ck_assert_int_eq(tf_list_length(&found.triangles_at, 0), 3);
    ck_assert_int_eq(found.parts, 2);
    ck_assert_int_eq(found.part[4], 0);
    ck_assert_int_eq(found.part[6], 1);
    ck_assert_int_eq(found.part[7], -1);
    ck_assert_int_eq(found.sheets, 1);
    tf_neighbors_free(&found);
    tf_surface_free(surface);
}
END_TEST

// A tetrahedron's normals all point out, or all in.
START_TEST(a_sheet_has_one_side_up)
{
    static const int triangle[] = {0, 1, 2, 0, 1, 3, 0, 2, 3, 1, 2, 3};
    static const double x[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    tf_mesh mesh = {3, 4, 4, triangle, 0, NULL};
    tf_surface *surface = surface_of(&mesh);
    int out = 0;
    find(surface);
    for (int t = 0; t < 4; t++) {
        tf_vector normal = tf_facet_normal(&found, x, t);
        int corner = found.triangle[3 * t];
        tf_vector middle = {{0.2, 0.2, 0.2}};
        tf_vector way =
            tf_vector_difference(tf_place(&found, x, corner), middle);
        out += tf_vector_dot(normal, way) > 0 ? 1 : -1;
    }
    ck_assert_int_eq(abs(out), 4);
    tf_neighbors_free(&found);
    tf_surface_free(surface);
}
END_TEST

// So do those of a loop in the plane.
START_TEST(a_loop_has_one_side_up)
{
    static const int edge[] = {0, 1, 1, 2, 3, 2, 0, 3};
    static const double x[] = {0, 0, 1, 0, 1, 1, 0, 1};
    tf_mesh mesh = {2, 4, 0, NULL, 4, edge};
    tf_surface *surface = surface_of(&mesh);
    int out = 0;
    find(surface);
    for (int e = 0; e < 4; e++) {
        tf_vector normal = tf_facet_normal(&found, x, e);
        tf_vector way = tf_vector_difference(
            tf_place(&found, x, found.edge[2 * e]), (tf_vector){{0.5, 0.5, 0}});
        out += tf_vector_dot(normal, way) > 0 ? 1 : -1;
    }
    ck_assert_int_eq(abs(out), 4);
    double around[4];
    ck_assert_double_eq(tf_mean_edge(&found, x, around), 1);
    ck_assert_double_eq(around[2], 1);
    tf_neighbors_free(&found);
    tf_surface_free(surface);
}
END_TEST

START_TEST(the_scale_is_a_power_of_two)
{
    for (int power = -1070; power < 1020; power++) {
        double x[2] = {0, -ldexp(1.5, power)}, to[2];
        ck_assert_int_eq(tf_scale_of(2, x), power);
        tf_scale_by(2, x, -power, to);
        ck_assert_double_ge(fabs(to[1]), 1);
        ck_assert_double_le(fabs(to[1]), 2);
    }
    ck_assert_int_eq(tf_scale_of(2, (double[]){0, 0}), 0);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("untangle/neighbors");
    TCase *tcase = tcase_create("neighbors");
    tcase_add_test(tcase, an_edge_may_have_three_triangles);
    tcase_add_test(tcase, a_sheet_has_one_side_up);
    tcase_add_test(tcase, a_loop_has_one_side_up);
    tcase_add_test(tcase, the_scale_is_a_power_of_two);
    suite_add_tcase(suite, tcase);
    return suite;
}
