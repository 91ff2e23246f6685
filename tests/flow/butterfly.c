// Butterfly points.
#include "flow/butterfly.h"

#include "support/adaptive_surfaces.h"
#include "support/flows.h"
#include "support/support.h"
#include "surgery/star.h"

START_TEST(flat_triangles_are_split_in_the_middle)
{
    tf_adaptive_surface *sheet = adaptive_sheet(4, 4);
    for (int c = 0; c < 3 * sheet->triangles; c++) {
        int a = tf_vertex_at(sheet, c);
        int b = tf_vertex_at(sheet, tf_corner_after(c));
        tf_vector point = tf_butterfly_point(sheet, c);
        tf_vector middle = tf_middle_of(sheet, a, b);
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq(point.x[k], middle.x[k]);
    }
    tf_adaptive_free(sheet);
}
END_TEST

// It is nearer to the sphere than the middle of the edge, except around the
// six vertices that have four triangles.
START_TEST(butterfly_points_of_a_sphere_are_nearer_to_it)
{
    static const double origin[3];
    tf_adaptive_surface *sphere = adaptive_sphere(8, origin, 1);
    int nearer = 0;
    for (int c = 0; c < 3 * sphere->triangles; c++) {
        int a = tf_vertex_at(sphere, c);
        int b = tf_vertex_at(sphere, tf_corner_after(c));
        double point = tf_vector_length(tf_butterfly_point(sphere, c));
        double middle = tf_vector_length(tf_middle_of(sphere, a, b));
        nearer += fabs(1 - point) < 0.5 * fabs(1 - middle);
    }
    ck_assert_int_gt(nearer, 3 * sphere->triangles * 9 / 10);
    tf_adaptive_free(sphere);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("flow/butterfly");
    TCase *tcase = tcase_create("points");
    tcase_add_test(tcase, flat_triangles_are_split_in_the_middle);
    tcase_add_test(tcase, butterfly_points_of_a_sphere_are_nearer_to_it);
    suite_add_tcase(suite, tcase);
    return suite;
}
