// Geodesic spheres.
#include "simulate/geodesic.h"

#include "geometry/vector.h"
#include "support/support.h"

static tf_body sphere(int n)
{
    tf_body body = {.axes = 3};
    tf_geodesic_add(&body, n);
    ck_assert(!body.failed);
    return body;
}

/// How often triangles have a side from a to b.
static int sides(const tf_body *body, int a, int b)
{
    int count = 0;
    for (int i = 0; i < 3 * body->triangles; i++)
        count += body->triangle[i] == a &&
                 body->triangle[i % 3 == 2 ? i - 2 : i + 1] == b;
    return count;
}

START_TEST(a_geodesic_sphere_is_closed_and_round)
{
    tf_body body = sphere(_i);
    ck_assert_int_eq(body.triangles, 20 * _i * _i);
    ck_assert_int_eq(body.vertices, 10 * _i * _i + 2);
    for (int v = 0; v < body.vertices; v++)
        ck_assert_double_eq_tol(
            tf_vector_length(tf_vector_at(body.position, v)), 1, 1e-15);
    for (int i = 0; i < 3 * body.triangles; i++)
        ck_assert_int_eq(sides(&body, body.triangle[i % 3 == 2 ? i - 2 : i + 1],
                               body.triangle[i]),
                         1);
    tf_body_free(&body);
}
END_TEST

START_TEST(triangles_face_outwards)
{
    tf_body body = sphere(5);
    for (const int *t = body.triangle; t < body.triangle + 3 * body.triangles;
         t += 3) {
        tf_vector a = tf_vector_at(body.position, t[0]);
        tf_vector normal = tf_vector_cross(
            tf_vector_difference(tf_vector_at(body.position, t[1]), a),
            tf_vector_difference(tf_vector_at(body.position, t[2]), a));
        ck_assert_double_gt(tf_vector_dot(a, normal), 0);
    }
    tf_body_free(&body);
}
END_TEST

START_TEST(edges_are_as_long_as_they_should_be)
{
    static const double edges[] = {0.05, 0.1, 0.3};
    for (int i = 0; i < 3; i++) {
        tf_body body = sphere(tf_geodesic_division(1, edges[i]));
        double sum = 0;
        for (int c = 0; c < 3 * body.triangles; c++)
            sum += tf_vector_length(tf_vector_difference(
                tf_vector_at(body.position,
                             body.triangle[c % 3 == 2 ? c - 2 : c + 1]),
                tf_vector_at(body.position, body.triangle[c])));
        ck_assert_double_eq_tol(sum / (3 * body.triangles), edges[i],
                                edges[i] / 10);
        tf_body_free(&body);
    }
    ck_assert_int_eq(tf_geodesic_division(1, 100), 1);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/geodesic");
    TCase *tcase = tcase_create("spheres");
    tcase_add_loop_test(tcase, a_geodesic_sphere_is_closed_and_round, 1, 7);
    tcase_add_test(tcase, triangles_face_outwards);
    tcase_add_test(tcase, edges_are_as_long_as_they_should_be);
    suite_add_tcase(suite, tcase);
    return suite;
}
