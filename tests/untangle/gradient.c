// The direction in which a crossing curve shortens.
#include "untangle/gradient.h"

#include "support/support.h"
#include "support/tangles.h"

#include <string.h>

static made_tangle own;
static tf_curves curves;
static tf_change change;

static void release(void)
{
    tf_curves_free(&curves);
    tf_change_free(&change);
    tangle_free(&own);
    curves = (tf_curves){.count = 0};
    change = (tf_change){.move = NULL};
}

/// A large triangle in the plane z = 0, and two triangles above an edge that is
/// tilted against it, 3 to 4.
static void make_ridge(void)
{
    tangle_begin(&own, 3);
    tangle_add(&own, 3, (double[]){-9, -9, 0, 9, -9, 0, 0, 9, 0});
    tangle_add(&own, 4,
               (double[]){-0.3, 0.1, -1, 0.5, 0.2, 2, //
                          1.5, -1, 0.7, 1.2, 1.5, 0.9});
    tangle_add_triangle(&own, 0, 1, 2);
    tangle_add_triangle(&own, 3, 4, 5);
    tangle_add_triangle(&own, 3, 4, 6);
    tangle_finish(&own);
}

static const tf_curve_point *point_of_edge(int a, int b)
{
    ck_assert(tf_curves_find(&curves, &own.tangle, own.x));
    for (size_t i = 0; i < curves.count; i++)
        if (curves.point[i].edge == tf_edge_of(&own.tangle.near, a, b))
            return &curves.point[i];
    return NULL;
}

/// Where an edge passes through the plane z = 0.
static tf_vector passage(const double x[], int from, int to)
{
    const double *a = x + 3 * (ptrdiff_t)from, *b = x + 3 * (ptrdiff_t)to;
    double t = a[2] / (a[2] - b[2]);
    tf_vector at;
    for (int k = 0; k < 3; k++)
        at.x[k] = a[k] + t * (b[k] - a[k]);
    return at;
}

static double length_to(tf_vector at, const tf_vector end[2])
{
    return tf_vector_length(tf_vector_difference(end[0], at)) +
           tf_vector_length(tf_vector_difference(end[1], at));
}

// By how much the curve on the edge's two triangles shortens as the edge moves,
// while its far ends stay, is what differences say.
START_TEST(the_way_is_the_gradient_of_the_length)
{
    make_ridge();
    const tf_curve_point *point = point_of_edge(3, 4);
    ck_assert_ptr_nonnull(point);
    ck_assert(tf_change_begin(&change, &own.tangle));
    tf_shorten_curve(&change, &own.tangle, own.x, point);
    tf_vector way = tf_vector_unit(change.move[3]), slope;
    tf_vector end[2] = {passage(own.x, 3, 5), passage(own.x, 3, 6)};
    for (int k = 0; k < 3; k++) {
        double h = 0x1p-20, length[2], moved[15];
        for (int i = 0; i < 2; i++) {
            memcpy(moved, own.x, sizeof moved);
            moved[9 + k] += i == 0 ? -h : h;
            moved[12 + k] += i == 0 ? -h : h;
            length[i] = length_to(passage(moved, 3, 4), end);
        }
        slope.x[k] = (length[0] - length[1]) / (2 * h);
    }
    double cosine = tf_vector_dot(way, tf_vector_unit(slope));
    ck_assert_double_gt(cosine, 1 - 1e-9);
    release();
}
END_TEST

START_TEST(both_elements_give_way)
{
    make_ridge();
    const tf_curve_point *point = point_of_edge(3, 4);
    ck_assert(tf_change_begin(&change, &own.tangle));
    tf_shorten_curve(&change, &own.tangle, own.x, point);
    tf_vector edge = tf_vector_sum(change.move[3], 1, change.move[4]);
    tf_vector facet = change.move[0];
    facet = tf_vector_sum(facet, 1, change.move[1]);
    facet = tf_vector_sum(facet, 1, change.move[2]);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(edge.x[k], -facet.x[k], 1e-14);
    ck_assert_double_le(tf_vector_length(edge),
                        own.tangle.edge / 4 * (1 + 1e-14));
    double weight = change.weight[0] + change.weight[1] + change.weight[2];
    ck_assert_double_eq_tol(weight, 1, 1e-14);
    ck_assert_double_eq_tol(change.weight[3] + change.weight[4], 1, 1e-14);
    release();
}
END_TEST

START_TEST(in_the_plane_the_nearer_end_is_the_way_off)
{
    tangle_begin(&own, 2);
    tangle_add(&own, 4, (double[]){0, 0, 4, 0, 1, -2, 1, 2});
    tangle_add_edge(&own, 0, 1);
    tangle_add_edge(&own, 2, 3);
    tangle_finish(&own);
    const tf_curve_point *point = point_of_edge(2, 3);
    ck_assert(tf_change_begin(&change, &own.tangle));
    tf_shorten_curve(&change, &own.tangle, own.x, point);
    ck_assert_double_lt(change.move[2].x[0], 0);
    ck_assert_double_eq(change.move[2].x[1], 0);
    ck_assert_double_gt(change.move[0].x[0], 0);
    release();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("untangle/gradient");
    TCase *tcase = tcase_create("gradient");
    tcase_add_test(tcase, the_way_is_the_gradient_of_the_length);
    tcase_add_test(tcase, both_elements_give_way);
    tcase_add_test(tcase, in_the_plane_the_nearer_end_is_the_way_off);
    suite_add_tcase(suite, tcase);
    return suite;
}
