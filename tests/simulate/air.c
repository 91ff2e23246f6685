#include "simulate/air.h"

#include "support/support.h"

#include <math.h>
#include <string.h>

/// Two triangles of area 1 / 2 each in the first two axes, of mass 1 / 4 at each
/// corner.
static tf_body plate(void)
{
    tf_body body = {.axes = 3};
    for (int v = 0; v < 4; v++) {
        tf_body_add_vertex(&body, (const double[]){v % 2, v / 2, 0});
        body.mass[v] = 0.25;
    }
    tf_body_add_triangle(&body, 0, 1, 3);
    tf_body_add_triangle(&body, 0, 2, 3); // its normal is the other one
    return body;
}

enum {
    COORDINATES = 12
};

/// The momentum of a plate after the air has blown on it.
static void blow(const tf_air *air, double time, double velocity[COORDINATES],
                 double momentum[3])
{
    tf_body body = plate();
    tf_air_blow(air, &body, time, 0.001, body.position, velocity);
    for (int k = 0; k < 3; k++) {
        momentum[k] = 0;
        for (int v = 0; v < 4; v++)
            momentum[k] += body.mass[v] * velocity[3 * v + k];
    }
    tf_body_free(&body);
}

// The same air, with its axes and those of the plate renamed.
START_TEST(any_axis_may_point_up)
{
    const tf_air air = {
        .drag = 2, .wind = {1, -2, 3}, .veer = 0.5, .gust = 1.5};
    for (int up = 0; up < 3; up++) {
        tf_air same = {.drag = 2, .veer = 0.5, .gust = 1.5};
        tf_body body = plate(), renamed = plate();
        renamed.up = up;
        double velocity[COORDINATES] = {0}, found[COORDINATES] = {0};
        for (int k = 0; k < 3; k++) {
            same.wind[(k + up) % 3] = air.wind[k];
            for (int v = 0; v < 4; v++)
                renamed.position[3 * v + (k + up) % 3] =
                    body.position[3 * v + k];
        }
        tf_air_blow(&air, &body, 0.7, 0.01, body.position, velocity);
        tf_air_blow(&same, &renamed, 0.7, 0.01, renamed.position, found);
        for (int i = 0; i < COORDINATES; i++)
            ck_assert_double_eq_tol(found[i / 3 * 3 + (i % 3 + up) % 3],
                                    velocity[i], 1e-15);
        ck_assert_double_ne(velocity[2], 0);
        tf_body_free(&body);
        tf_body_free(&renamed);
    }
}
END_TEST

// The force is drag times area times speed.
START_TEST(wind_pushes_head_on)
{
    const tf_air air = {.drag = 2, .wind = {0, 0, 5}};
    double velocity[COORDINATES] = {0}, momentum[3];
    blow(&air, 0, velocity, momentum);
    ck_assert_double_eq(momentum[0], 0);
    ck_assert_double_eq(momentum[1], 0);
    ck_assert_double_eq_tol(momentum[2], 0.001 * 2 * 1 * 5, 1e-4);
}
END_TEST

START_TEST(wind_along_a_surface_does_nothing)
{
    const tf_air air = {.drag = 2, .wind = {3, 4, 0}};
    double velocity[COORDINATES] = {0}, momentum[3];
    blow(&air, 0, velocity, momentum);
    for (int i = 0; i < COORDINATES; i++)
        ck_assert_double_eq(velocity[i], 0);
}
END_TEST

START_TEST(still_air_slows)
{
    const tf_air air = {.drag = 2};
    double velocity[COORDINATES], momentum[3];
    for (int i = 0; i < COORDINATES; i++)
        velocity[i] = 1;
    blow(&air, 0, velocity, momentum);
    ck_assert_double_eq(momentum[0], 1);
    ck_assert_double_eq_tol(momentum[2], 1 - 0.001 * 2, 1e-5);
}
END_TEST

START_TEST(wind_veers)
{
    const tf_air air = {.drag = 2, .wind = {0, 5, 0}, .veer = 0.5};
    double velocity[COORDINATES] = {0}, momentum[3];
    tf_body body = plate();
    for (int v = 0; v < 4; v++) { // upright, in the first and the last axis
        body.position[3 * v + 2] = body.position[3 * v + 1];
        body.position[3 * v + 1] = 0;
    }
    tf_air_blow(&air, &body, 2, 0.001, body.position, velocity);
    momentum[1] = 0;
    for (int v = 0; v < 4; v++)
        momentum[1] += body.mass[v] * velocity[3 * v + 1];
    ck_assert_double_eq_tol(momentum[1], 0.001 * 2 * 5 * cos(1), 1e-4);
    tf_body_free(&body);
}
END_TEST

START_TEST(gusts_come_from_the_sides)
{
    const tf_air air = {.drag = 2, .wind = {5, 0, 0}, .gust = 3};
    double most = 0, least = 0, momentum[3];
    for (int i = 0; i < 100; i++) {
        double velocity[COORDINATES] = {0};
        blow(&air, 0.1 * i, velocity, momentum);
        most = fmax(most, momentum[2]);
        least = fmin(least, momentum[2]);
    }
    ck_assert_double_gt(most, 0.001);
    ck_assert_double_lt(least, -0.001);
    ck_assert_double_lt(most, 0.001 * 2 * 3);
}
END_TEST

START_TEST(scripted_and_flat_triangles_are_not_moved)
{
    const tf_air air = {.drag = 2, .wind = {0, 0, 5}};
    double velocity[COORDINATES] = {0};
    tf_body body = plate();
    body.mass[3] = 0;
    body.position[3] = 0; // the first triangle has no area
    tf_air_blow(&air, &body, 0, 0.001, body.position, velocity);
    ck_assert_double_gt(velocity[2], 0);
    ck_assert_double_eq(velocity[5], 0);
    ck_assert_double_eq(velocity[11], 0);
    body.axes = 2;
    memset(velocity, 0, sizeof velocity);
    tf_air_blow(&air, &body, 0, 0.001, body.position, velocity);
    ck_assert_double_eq(velocity[2], 0);
    tf_body_free(&body);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/air");
    TCase *tcase = tcase_create("wind");
    tcase_add_test(tcase, wind_pushes_head_on);
    tcase_add_test(tcase, any_axis_may_point_up);
    tcase_add_test(tcase, wind_along_a_surface_does_nothing);
    tcase_add_test(tcase, still_air_slows);
    tcase_add_test(tcase, wind_veers);
    tcase_add_test(tcase, gusts_come_from_the_sides);
    tcase_add_test(tcase, scripted_and_flat_triangles_are_not_moved);
    suite_add_tcase(suite, tcase);
    return suite;
}
