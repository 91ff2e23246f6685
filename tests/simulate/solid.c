#include "simulate/solid.h"

#include "support/simulations.h"
#include "support/support.h"

#include <math.h>

/// How often triangles have the side from a to b, in this direction.
static int sides(const tf_body *body, int a, int b)
{
    int times = 0;
    for (int i = 0; i < 3 * body->triangles; i++)
        times += body->triangle[i] == a &&
                 body->triangle[i - i % 3 + (i + 1) % 3] == b;
    return times;
}

/// Six times the volume inside.
static double volume(const tf_body *body)
{
    double sum = 0;
    for (int t = 0; t < body->triangles; t++) {
        const double *x[3];
        for (int i = 0; i < 3; i++)
            x[i] = body->position + 3 * body->triangle[3 * t + i];
        for (int k = 0; k < 3; k++) {
            int l = (k + 1) % 3, m = (k + 2) % 3;
            sum += x[0][k] * (x[1][l] * x[2][m] - x[1][m] * x[2][l]);
        }
    }
    return sum / 6;
}

/// Expects a closed surface, with its normals outward, that is clear and fixed.
static void expect_closed(const tf_body *body, int euler)
{
    ck_assert(!body->failed);
    for (int i = 0; i < 3 * body->triangles; i++) {
        int a = body->triangle[i];
        int b = body->triangle[i - i % 3 + (i + 1) % 3];
        ck_assert_msg(sides(body, a, b) == 1 && sides(body, b, a) == 1,
                      "the edge %d %d", a, b);
    }
    ck_assert_int_eq(body->vertices - body->triangles / 2, euler);
    for (int v = 0; v < body->vertices; v++)
        ck_assert_double_eq(body->mass[v], 0);
    expect_clear(body);
}

START_TEST(a_ball_is_round)
{
    const double center[] = {1, 2, 3};
    for (int sectors = 3; sectors < 12; sectors++) {
        tf_body body = {.axes = 3};
        tf_ball_add(&body, center, 0.5, sectors);
        expect_closed(&body, 2);
        for (int v = 0; v < body.vertices; v++) {
            const double *x = body.position + 3 * v;
            double square = 0;
            for (int k = 0; k < 3; k++)
                square += (x[k] - center[k]) * (x[k] - center[k]);
            ck_assert_double_eq_tol(sqrt(square), 0.5, 1e-15);
        }
        tf_body_free(&body);
    }
}
END_TEST

START_TEST(solids_have_their_volumes)
{
    const double pi = 3.141592653589793, at[] = {1, 2, 3}, radius[] = {2, 0.5};
    tf_body body = {.axes = 3};
    tf_ball_add(&body, at, 0.5, 80);
    ck_assert_double_eq_tol(volume(&body), pi / 6, 0.01);
    tf_body_free(&body);
    body.axes = 3;
    tf_column_add(&body, at, 0.5, 2, 80, 3);
    ck_assert_double_eq_tol(volume(&body), pi / 2, 0.01);
    tf_body_free(&body);
    body.axes = 3;
    tf_ring_add(&body, at, radius, 80, 40);
    ck_assert_double_eq_tol(volume(&body), pi * pi, 0.1);
    tf_body_free(&body);
}
END_TEST

START_TEST(columns_and_rings_are_closed)
{
    const double at[] = {1, 2, 3}, radius[] = {2, 0.5};
    for (int sectors = 3; sectors < 9; sectors++) {
        tf_body body = {.axes = 3};
        tf_column_add(&body, at, 0.5, 2, sectors, sectors - 2);
        expect_closed(&body, 2);
        tf_body_free(&body);
        body.axes = 3;
        tf_ring_add(&body, at, radius, sectors, sectors + 1);
        expect_closed(&body, 0);
        tf_body_free(&body);
    }
}
END_TEST

START_TEST(a_floor_is_flat)
{
    tf_body body = {.axes = 3};
    tf_floor_add(&body, -1, 4);
    ck_assert_int_eq(body.triangles, 2);
    for (int v = 0; v < 4; v++) {
        ck_assert_double_eq(fabs(body.position[3 * v]), 2);
        ck_assert_double_eq(fabs(body.position[3 * v + 1]), 2);
        ck_assert_double_eq(body.position[3 * v + 2], -1);
    }
    tf_body_free(&body);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/solid");
    TCase *tcase = tcase_create("solids");
    tcase_add_test(tcase, a_ball_is_round);
    tcase_add_test(tcase, solids_have_their_volumes);
    tcase_add_test(tcase, columns_and_rings_are_closed);
    tcase_add_test(tcase, a_floor_is_flat);
    suite_add_tcase(suite, tcase);
    return suite;
}
