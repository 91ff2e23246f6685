// How simplices at rest touch, against linear programs in rational numbers.
#include "surgery/touch.h"

#include "support/at_rest.h"
#include "support/support.h"

#include <string.h>

START_TEST(points_and_edges_touch_triangles)
{
    generator random = generator_new(1);
    int touched = 0, count = (int)cases(20000);
    for (int i = 0; i < count; i++) {
        double x[5][3];
        place_on_lattice(&random, 5, 2 + i % 4, x);
        const double *const corner[] = {x[2], x[3], x[4]};
        bool point = tf_point_touches_triangle(x[0], corner);
        bool edge = tf_edge_touches_triangle(x[0], x[1], corner);
        ck_assert_int_eq(point, meet_at_rest(3, 1, x, 3, x + 2));
        ck_assert_int_eq(edge, meet_at_rest(3, 2, x, 3, x + 2));
        ck_assert_int_eq(edge, tf_edge_touches_triangle(x[1], x[0], corner));
        touched += edge;
    }
    ck_assert(10 * touched > count && 10 * (count - touched) > count);
}
END_TEST

static tf_facet facet_of(int a, int b, int c, double x[][3])
{
    return (tf_facet){{a, b, c}, {x[a], x[b], x[c]}};
}

/// Two triangles of the points 0, 1, 2 and others, one of which may be collinear.
static bool make_facets(generator *random, int shared, double x[][3],
                        tf_facet *a, tf_facet *b)
{
    place_on_lattice(random, 6, 2 + below(random, 3), x);
    int other[3];
    for (int i = 0; i < 3; i++)
        other[i] = i < shared ? 2 - i : i + 3;
    *a = facet_of(0, 1, 2, x);
    *b = facet_of(other[0], other[1], other[2], x);
    return !tf_are_collinear(x[0], x[1], x[2]) ||
           !tf_are_collinear(x[other[0]], x[other[1]], x[other[2]]);
}

/// A point a 1024th of the way from one to another: exact on a small lattice.
static void step_towards(const double from[3], const double to[3],
                         double step[3])
{
    for (int k = 0; k < 3; k++)
        step[k] = from[k] + (to[k] - from[k]) / 1024;
}

static void copy_triangle(const tf_facet *from, double x[3][3])
{
    for (int i = 0; i < 3; i++)
        memcpy(x[i], from->corner[i], sizeof x[i]);
}

START_TEST(triangles_that_share_nothing_overlap_where_they_meet)
{
    generator random = generator_new(2);
    int overlapped = 0;
    for (long i = 0; i < cases(10000); i++) {
        double x[6][3];
        tf_facet a, b;
        if (!make_facets(&random, 0, x, &a, &b))
            continue;
        bool found = tf_facets_overlap(&a, &b);
        ck_assert_int_eq(found, meet_at_rest(3, 3, x, 3, x + 3));
        overlapped += found;
    }
    ck_assert_int_gt(overlapped, 20);
}
END_TEST

// What the triangles have in common beyond the vertex reaches to it: it is on
// the side of one that is opposite to the vertex, or of the other.
START_TEST(triangles_on_a_vertex_overlap_on_a_far_side)
{
    generator random = generator_new(3);
    int overlapped = 0;
    for (long i = 0; i < cases(10000); i++) {
        double x[6][3], near_a[3][3], near_b[3][3];
        tf_facet a, b;
        if (!make_facets(&random, 1, x, &a, &b))
            continue;
        copy_triangle(&a, near_a); // the common vertex is its last
        copy_triangle(&b, near_b); // and its first
        bool met = meet_at_rest(3, 2, near_a, 3, near_b) ||
                   meet_at_rest(3, 2, near_b + 1, 3, near_a);
        ck_assert_int_eq(tf_facets_overlap(&a, &b), met);
        ck_assert_int_eq(tf_facets_overlap(&b, &a), met);
        overlapped += met;
    }
    ck_assert_int_gt(overlapped, 20);
}
END_TEST

// A step from the middle of the edge into one triangle, which is not collinear,
// is a step into the other.
START_TEST(triangles_on_an_edge_overlap_if_folded)
{
    generator random = generator_new(4);
    int overlapped = 0;
    for (long i = 0; i < cases(10000); i++) {
        double x[6][3], middle[3], step[1][3], other[3][3];
        tf_facet a, b;
        if (!make_facets(&random, 2, x, &a, &b))
            continue;
        for (int k = 0; k < 3; k++)
            middle[k] = (x[1][k] + x[2][k]) / 2;
        bool collinear = tf_are_collinear(x[0], x[1], x[2]);
        step_towards(middle, x[collinear ? 5 : 0], step[0]);
        copy_triangle(collinear ? &a : &b, other);
        bool folded = meet_at_rest(3, 1, step, 3, other);
        ck_assert_int_eq(tf_facets_overlap(&a, &b), folded);
        overlapped += folded;
    }
    ck_assert_int_gt(overlapped, 10);
}
END_TEST

START_TEST(a_triangle_overlaps_itself)
{
    double x[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    tf_facet a = facet_of(0, 1, 2, x), b = facet_of(0, 2, 1, x);
    ck_assert(tf_facets_overlap(&a, &b));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surgery/touch");
    TCase *tcase = tcase_create("closed");
    tcase_add_test(tcase, points_and_edges_touch_triangles);
    tcase_add_test(tcase, triangles_that_share_nothing_overlap_where_they_meet);
    tcase_add_test(tcase, triangles_on_a_vertex_overlap_on_a_far_side);
    tcase_add_test(tcase, triangles_on_an_edge_overlap_if_folded);
    tcase_add_test(tcase, a_triangle_overlaps_itself);
    suite_add_tcase(suite, tcase);
    return suite;
}
