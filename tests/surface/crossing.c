// How elements at rest intersect, against linear programs in rational numbers.
#include "surface/crossing.h"

#include "support/at_rest.h"
#include "support/support.h"

#include <string.h>

START_TEST(edges_cross_in_the_plane)
{
    generator random = generator_new(1);
    int crossed = 0, count = (int)cases(20000);
    for (int i = 0; i < count; i++) {
        double x[4][3];
        place_on_lattice(&random, 4, 2 + i % 4, x);
        bool found = tf_edges_cross(x[0], x[1], x[2], x[3]);
        ck_assert_int_eq(found, meet_at_rest(2, 2, x, 2, x + 2));
        ck_assert_int_eq(found, tf_edges_cross(x[3], x[2], x[0], x[1]));
        crossed += found;
    }
    ck_assert(10 * crossed > count && 10 * (count - crossed) > count);
}
END_TEST

/// Whether an edge passes through the inside of a triangle.
static bool pass(double edge[][3], double triangle[][3])
{
    if (!meet_at_rest(3, 2, edge, 3, triangle) ||
        meet_at_rest(3, 1, edge, 3, triangle) ||
        meet_at_rest(3, 1, edge + 1, 3, triangle))
        return false;
    for (int i = 0; i < 3; i++) {
        double side[2][3];
        memcpy(side[0], triangle[i], sizeof side[0]);
        memcpy(side[1], triangle[(i + 1) % 3], sizeof side[1]);
        if (meet_at_rest(3, 2, edge, 2, side))
            return false;
    }
    return true;
}

START_TEST(edges_pass_through_triangles)
{
    generator random = generator_new(2);
    int passed = 0, count = (int)cases(20000);
    for (int i = 0; i < count; i++) {
        double x[5][3];
        place_on_lattice(&random, 5, 3 + i % 6, x);
        bool found = tf_edge_crosses_triangle(x[0], x[1], x[2], x[3], x[4]);
        ck_assert_int_eq(found, pass(x, x + 2));
        ck_assert_int_eq(
            found, tf_edge_crosses_triangle(x[1], x[0], x[3], x[2], x[4]));
        passed += found;
    }
    ck_assert(100 * passed > count);
}
END_TEST

START_TEST(points_lie_in_a_plane)
{
    static const double a[] = {0, 0, 0}, b[] = {1, 0, 0}, c[] = {0, 1, 0};
    double d[] = {5, 7, 0};
    ck_assert(tf_are_coplanar(a, b, c, d));
    d[2] = 4.9e-324;
    ck_assert(!tf_are_coplanar(a, b, c, d));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surface/crossing");
    TCase *tcase = tcase_create("crossing");
    tcase_add_test(tcase, edges_cross_in_the_plane);
    tcase_add_test(tcase, edges_pass_through_triangles);
    tcase_add_test(tcase, points_lie_in_a_plane);
    suite_add_tcase(suite, tcase);
    return suite;
}
