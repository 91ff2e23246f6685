#include "linear/rigid_motion.h"

#include "support/environments.h"
#include "support/statuses.h"
#include "support/support.h"

#include <math.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

// A bar from (0, 0) to (1, 0) turns by a quarter about its first end.  A point
// rests at 60 degrees: they meet at t = 2/3.

static const double bar_vertices[] = {0, 0, 1, 0};

static tf_rigid_body bar(void)
{
    return (tf_rigid_body){.vertices = bar_vertices,
                           .rotation = {0, 0, pi / 2}};
}

static tf_advancement turn(double threshold, double radius)
{
    double point[] = {radius / 2, radius * sqrt(0.75)};
    tf_rigid_body turning = bar();
    tf_rigid_body rest = {.vertices = point, .center = {point[0], point[1]}};
    tf_advance_limits limits = {.threshold = threshold};
    tf_advancement at;
    ck_assert_int_eq(tf_advance_point_edge(&limits, &rest, &turning, &at),
                     TF_OK);
    return at;
}

/// When the point is at a height over the bar.
static double time_of_height(double height, double radius)
{
    return 2.0 / 3 - asin(height / radius) * 2 / pi;
}

START_TEST(a_turning_bar_hits_a_point)
{
    double radius = _i == 0 ? 1 : 0.5;
    int last_steps = 0;
    double last_error = 1;
    for (double threshold = 0.1; threshold > 1e-13; threshold /= 10) {
        tf_advancement at = turn(threshold, radius);
        double error = 2.0 / 3 - at.time;
        ck_assert_int_eq(at.verdict, TF_HIT);
        ck_assert_double_le(at.distance, threshold);
        ck_assert_double_ge(at.time, time_of_height(threshold, radius) - 1e-15);
        ck_assert_double_le(at.time,
                            time_of_height(threshold / 2, radius) + 1e-15);
        ck_assert_double_lt(error, last_error);
        ck_assert_int_ge(at.steps, last_steps);
        last_error = error;
        last_steps = at.steps;
    }
    ck_assert_double_lt(last_error, 1e-12);
    ck_assert_double_gt(last_error, 0);
}
END_TEST

START_TEST(a_point_beyond_the_bar_is_apart)
{
    tf_advancement at = turn(0.01, 1.02);
    ck_assert_int_eq(at.verdict, TF_APART);
    ck_assert_double_eq(at.time, 1);
}
END_TEST

START_TEST(positions_turn_and_move)
{
    tf_rigid_body body = bar();
    double x[3] = {7, 7, 7};
    body.center[1] = -1;
    body.velocity[0] = 4;
    body.velocity[2] = 9; // not read
    // The bar's end is at (1, 1) from the center: after half the step it is at
    // (0, sqrt 2), and the center at (2, -1).
    ck_assert_int_eq(tf_rigid_position(2, &body, 1, 0.5, x), TF_OK);
    ck_assert_double_eq_tol(x[0], 2, 1e-15);
    ck_assert_double_eq_tol(x[1], sqrt(2) - 1, 1e-15);
    ck_assert_double_eq(x[2], 7);
}
END_TEST

START_TEST(positions_turn_about_any_axis)
{
    // By 120 degrees about the diagonal: x to y to z.
    static const double vertices[] = {1, 2, 3};
    double angle = 2 * pi / 3 / sqrt(3), x[3];
    tf_rigid_body body = {.vertices = vertices,
                          .rotation = {angle, angle, angle}};
    ck_assert_int_eq(tf_rigid_position(3, &body, 0, 1, x), TF_OK);
    ck_assert_double_eq_tol(x[0], 3, 1e-14);
    ck_assert_double_eq_tol(x[1], 1, 1e-14);
    ck_assert_double_eq_tol(x[2], 2, 1e-14);
}
END_TEST

START_TEST(positions_that_cannot_be_are_refused)
{
    tf_rigid_body body = bar(), spinning = bar();
    double x[3] = {7, 7, 7};
    ck_assert_int_eq(tf_rigid_position(4, &body, 0, 0, x), TF_BAD_AXES);
    ck_assert_int_eq(tf_rigid_position(-1, &body, 0, 0, x), TF_BAD_AXES);
    ck_assert_int_eq(tf_rigid_position(2, &body, -1, 0, x), TF_BAD_INDEX);
    ck_assert_int_eq(tf_rigid_position(2, &body, 0, NAN, x), TF_NOT_FINITE);
    spinning.rotation[2] = INFINITY;
    ck_assert_int_eq(tf_rigid_position(2, &spinning, 0, 0, x), TF_NOT_FINITE);
    ck_assert(x[0] == 7 && x[1] == 7 && x[2] == 7);
}
END_TEST

// Triangles -------------------------------------------------------------------

static const double floor_vertices[] = {-9, -9, 0, 9, -9, 0, 0, 9, 0};

static tf_advancement advance_to_floor(const tf_rigid_body *body,
                                       tf_advance_limits limits)
{
    tf_rigid_body ground = {.vertices = floor_vertices};
    tf_advancement at, other;
    ck_assert_int_eq(tf_advance_triangles(&limits, body, &ground, &at), TF_OK);
    ck_assert_int_eq(tf_advance_triangles(&limits, &ground, body, &other),
                     TF_OK);
    ck_assert_int_eq(at.verdict, other.verdict);
    ck_assert_int_eq(at.steps, other.steps);
    ck_assert_double_eq_tol(at.time, other.time, 1e-12);
    return at;
}

START_TEST(a_falling_triangle_hits_the_floor)
{
    static const double vertices[] = {0, 0, 1, 1, 0, 2, 0, 1, 2};
    tf_rigid_body body = {.vertices = vertices, .velocity = {3, 1, -4}};
    tf_advancement at =
        advance_to_floor(&body, (tf_advance_limits){.threshold = 1e-9});
    ck_assert_int_eq(at.verdict, TF_HIT);
    ck_assert_int_eq(at.steps, 1);
    ck_assert_double_eq_tol(at.time, 0.25, 1e-9);
    ck_assert_double_lt(at.time, 0.25);
    body.velocity[2] = 4;
    at = advance_to_floor(&body, (tf_advance_limits){.threshold = 1e-9});
    ck_assert_int_eq(at.verdict, TF_APART);
    ck_assert_int_eq(at.steps, 1);
}
END_TEST

// A triangle in the plane x = 0 turns about the x axis at a height of 1/2; its
// corner at the distance 1 comes down from 90 to 30 degrees below the horizon.

START_TEST(a_turning_triangle_hits_the_floor)
{
    static const double vertices[] = {0, 0, 1.5, 0, 0.1, 0.5, 0, -0.1, 0.5};
    tf_rigid_body body = {
        .vertices = vertices, .center = {0, 0, 0.5}, .rotation = {pi, 0, 0}};
    double last = 1;
    for (double threshold = 0.01; threshold > 1e-12; threshold /= 10) {
        tf_advancement at = advance_to_floor(
            &body, (tf_advance_limits){.threshold = threshold});
        double error = 2.0 / 3 - at.time;
        ck_assert_int_eq(at.verdict, TF_HIT);
        ck_assert_double_gt(error, 0);
        ck_assert_double_lt(error, last);
        last = error;
    }
    ck_assert_double_lt(last, 1e-11);
}
END_TEST

START_TEST(crossed_triangles_touch_at_once)
{
    static const double vertices[] = {0, 0, -1, 1, 0, 1, -1, 0, 1};
    tf_rigid_body body = {.vertices = vertices, .velocity = {1, 0, 0}};
    tf_advancement at = advance_to_floor(&body, (tf_advance_limits){0});
    ck_assert_int_eq(at.verdict, TF_HIT);
    ck_assert_int_eq(at.steps, 0);
    ck_assert_double_eq(at.distance, 0);
}
END_TEST

// Random bodies never pass through each other: at all times up to the one
// reached they are apart.

static void random_body(generator *random, double vertices[9],
                        tf_rigid_body *body, double offset)
{
    *body = (tf_rigid_body){.vertices = vertices};
    for (int i = 0; i < 9; i++)
        vertices[i] = uniform(random, -1, 1) + (i % 3 == 0 ? offset : 0);
    for (int k = 0; k < 3; k++) {
        body->center[k] = uniform(random, -1, 1) + (k == 0 ? offset : 0);
        body->velocity[k] = uniform(random, -2, 2);
        body->rotation[k] = uniform(random, -3, 3);
    }
}

static double distance_at(const tf_rigid_body body[2], double time)
{
    // Two bodies at rest where they are then.
    double vertices[2][9];
    tf_rigid_body still[2] = {{.vertices = vertices[0]},
                              {.vertices = vertices[1]}};
    for (int b = 0; b < 2; b++)
        for (int i = 0; i < 3; i++)
            tf_rigid_position(3, &body[b], i, time, vertices[b] + 3 * i);
    tf_advancement at;
    tf_advance_limits limits = {0};
    ck_assert_int_eq(tf_advance_triangles(&limits, &still[0], &still[1], &at),
                     TF_OK);
    return at.distance;
}

START_TEST(advancement_never_passes_a_contact)
{
    generator random = generator_new(1);
    for (long i = 0; i < cases(2000); i++) {
        double vertices[2][9];
        tf_rigid_body body[2];
        random_body(&random, vertices[0], &body[0], 0);
        random_body(&random, vertices[1], &body[1], 2.5);
        tf_advance_limits limits = {.threshold = 1e-4};
        tf_advancement at;
        ck_assert_int_eq(tf_advance_triangles(&limits, &body[0], &body[1], &at),
                         TF_OK);
        ck_assert_double_eq_tol(distance_at(body, at.time), at.distance, 1e-9);
        for (int n = 0; n < 50 && at.steps > 0; n++)
            ck_assert_double_gt(distance_at(body, at.time * n / 50), 0);
    }
}
END_TEST

// Statuses --------------------------------------------------------------------

static tf_status try_bodies(tf_advance_limits limits, int body, int field,
                            double value, tf_advancement *at)
{
    double vertices[2][9];
    for (int b = 0; b < 2; b++)
        memcpy(vertices[b], floor_vertices, sizeof floor_vertices);
    tf_rigid_body bodies[] = {{.vertices = vertices[0]},
                              {.vertices = vertices[1]}};
    tf_rigid_body *bad = &bodies[body];
    double *number[] = {&vertices[body][8], &bad->center[1], &bad->velocity[2],
                        &bad->rotation[0]};
    if (field >= 0)
        *number[field] = value;
    return tf_advance_triangles(&limits, &bodies[0], &bodies[1], at);
}

START_TEST(bad_input_is_refused)
{
    static const double bad[] = {NAN, INFINITY, -INFINITY};
    tf_advancement at = {.steps = 42};
    for (int i = 0; i < 3; i++)
        for (int body = 0; body < 2; body++)
            for (int field = 0; field < 4; field++)
                ck_assert_int_eq(try_bodies((tf_advance_limits){0}, body, field,
                                            bad[i], &at),
                                 TF_NOT_FINITE);
    ck_assert_int_eq(
        try_bodies((tf_advance_limits){.threshold = -1}, 0, -1, 0, &at),
        TF_BAD_OPTION);
    ck_assert_int_eq(at.steps, 42);
    ck_assert_int_eq(try_bodies((tf_advance_limits){0}, 0, -1, 0, &at), TF_OK);
}
END_TEST

START_TEST(in_the_plane_other_components_are_not_read)
{
    tf_rigid_body turning = bar(), rest = bar();
    rest.center[2] = rest.velocity[2] = rest.rotation[0] = NAN;
    tf_advancement at;
    tf_advance_limits limits = {0};
    ck_assert_int_eq(tf_advance_point_edge(&limits, &rest, &turning, &at),
                     TF_OK);
    ck_assert_int_eq(at.verdict, TF_HIT);
    rest.rotation[2] = NAN;
    ck_assert_int_eq(tf_advance_point_edge(&limits, &rest, &turning, &at),
                     TF_NOT_FINITE);
}
END_TEST

START_TEST(a_broken_environment_is_reported)
{
    tf_advancement at;
    environment_break(_i);
    tf_status status = try_bodies((tf_advance_limits){0}, 0, -1, 0, &at);
    environment_restore();
    ck_assert_int_eq(status, TF_BAD_ENVIRONMENT);
}
END_TEST

START_TEST(a_null_pointer_breaks_the_contract)
{
    tf_advance_limits limits = {0};
    tf_rigid_body body = bar(), none = {0};
    tf_advancement at;
    exit_on_broken_contract();
    tf_advance_point_edge(_i == 0 ? NULL : &limits, _i == 1 ? NULL : &body,
                          _i == 2   ? NULL
                          : _i == 3 ? &none
                                    : &body,
                          _i == 4 ? NULL : &at);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("linear/rigid_motion");
    TCase *c = tcase_create("rigid motion");
    tcase_add_loop_test(c, a_turning_bar_hits_a_point, 0, 2);
    tcase_add_test(c, a_point_beyond_the_bar_is_apart);
    tcase_add_test(c, positions_turn_and_move);
    tcase_add_test(c, positions_turn_about_any_axis);
    tcase_add_test(c, positions_that_cannot_be_are_refused);
    tcase_add_test(c, a_falling_triangle_hits_the_floor);
    tcase_add_test(c, a_turning_triangle_hits_the_floor);
    tcase_add_test(c, crossed_triangles_touch_at_once);
    tcase_add_test(c, advancement_never_passes_a_contact);
    tcase_add_test(c, bad_input_is_refused);
    tcase_add_test(c, in_the_plane_other_components_are_not_read);
    tcase_add_loop_test(c, a_broken_environment_is_reported, 0, environments());
    tcase_add_loop_exit_test(c, a_null_pointer_breaks_the_contract,
                             BROKEN_CONTRACT, 0, 5);
    suite_add_tcase(s, c);
    return s;
}
