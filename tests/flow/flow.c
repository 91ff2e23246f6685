// A surface flows: it stays embedded, keeps its volume, and comes back.
#include "flow/flow.h"

#include "simulate/flow_fields.h"
#include "support/adaptive_surfaces.h"
#include "support/cancelling.h"
#include "support/careless.h"
#include "support/flows.h"
#include "support/scrambled_workers.h"
#include "support/support.h"
#include "surgery/adaptive_surface.h"

#include <math.h>
#include <signal.h>

enum {
    STEPS = 100
};

static const double center[] = {0.35, 0.35, 0.35}, radius = 0.15;

static tf_velocity_field *vortices = tf_vortices;

static tf_flow *flow_of(tf_adaptive_surface *surface)
{
    tf_flow *flow = NULL;
    ck_assert_int_eq(tf_flow_create(surface, &flow), TF_OK);
    return flow;
}

/// The root of the mean square of the distances of vertices from the sphere.
static double radius_error(const tf_adaptive_surface *surface)
{
    double sum = 0;
    for (int v = 0; v < surface->vertices; v++) {
        const double *x = coordinates_of(surface, v);
        double error =
            hypot(hypot(x[0] - center[0], x[1] - center[1]), x[2] - center[2]) -
            radius;
        sum += error * error;
    }
    return sqrt(sum / surface->vertices);
}

// There and back --------------------------------------------------------------

START_TEST(a_ball_returns_from_vortices_with_its_volume)
{
    tf_adaptive_surface *surface = adaptive_sphere(12, center, radius);
    tf_flow *flow = flow_of(surface);
    tf_flow_options options = {
        .edge = 0.023, .velocity = tf_field_apply, .context = &vortices};
    const tf_flow_report *report;
    mpq_t before;
    mpq_init(before);
    exact_volume(surface, before);
    for (int i = 0; i < STEPS; i++) {
        ck_assert_int_eq(tf_flow_step(flow, 3.0 * i / STEPS, 3.0 / STEPS,
                                      &options, &report, NULL),
                         TF_OK);
        if (i % 10 == 9)
            expect_embedded(surface);
        if (i == STEPS / 2)
            ck_assert_int_gt(surface->triangles, 3000);
    }
    double volume = mpq_get_d(before) / 6;
    ck_assert_double_lt(fabs(volume_gained(surface, before)), 2e-4 * volume);
    ck_assert_double_lt(radius_error(surface), 0.015 * radius);
    ck_assert_int_lt(surface->triangles, 2500);
    mpq_clear(before);
    tf_flow_free(flow);
    tf_adaptive_free(surface);
}
END_TEST

/// Lets a surface flow a little, on some workers.
static tf_adaptive_surface *flow_on(int workers)
{
    tf_parallel parallel = scrambled_workers(&workers);
    tf_adaptive_surface *surface = adaptive_sphere(6, center, radius);
    tf_flow *flow = flow_of(surface);
    tf_flow_options options = {.edge = 0.03,
                               .velocity = tf_field_apply,
                               .context = &vortices,
                               .parallel = &parallel};
    for (int i = 0; i < 20; i++)
        ck_assert_int_eq(
            tf_flow_step(flow, 0.05 * i, 0.05, &options, NULL, NULL), TF_OK);
    tf_flow_free(flow);
    return surface;
}

static void expect_same(const tf_adaptive_surface *one,
                        const tf_adaptive_surface *two)
{
    ck_assert_int_eq(one->vertices, two->vertices);
    ck_assert_int_eq(one->triangles, two->triangles);
    ck_assert_mem_eq(coordinates_of(one, 0), coordinates_of(two, 0),
                     3 * sizeof(double) * (size_t)one->vertices);
    ck_assert_mem_eq(tf_adaptive_mesh(one)->triangle,
                     tf_adaptive_mesh(two)->triangle,
                     3 * sizeof(int) * (size_t)one->triangles);
}

START_TEST(workers_change_no_bit)
{
    tf_adaptive_surface *one = flow_on(1), *two = flow_on(2);
    expect_same(one, two);
    tf_adaptive_free(one);
    tf_adaptive_free(two);
}
END_TEST

// Memory that is kept changes no bit.
START_TEST(a_flow_remembers_nothing_of_its_steps)
{
    tf_adaptive_surface *surface = adaptive_sphere(6, center, radius);
    tf_adaptive_surface *same = adaptive_sphere(6, center, radius);
    tf_flow *flow = flow_of(surface);
    tf_flow_options options = {
        .edge = 0.03, .velocity = tf_field_apply, .context = &vortices};
    for (int i = 0; i < 20; i++) {
        tf_flow *anew = flow_of(same);
        ck_assert_int_eq(
            tf_flow_step(flow, 0.05 * i, 0.05, &options, NULL, NULL), TF_OK);
        ck_assert_int_eq(
            tf_flow_step(anew, 0.05 * i, 0.05, &options, NULL, NULL), TF_OK);
        ck_assert_uint_gt(tf_flow_memory(flow), tf_flow_memory(anew) / 2);
        tf_flow_free(anew);
    }
    expect_same(surface, same);
    tf_flow_free(flow);
    tf_adaptive_free(surface);
    tf_adaptive_free(same);
}
END_TEST

/// Lets a surface flow step by step, by all of their parts.
START_TEST(a_step_is_its_parts)
{
    tf_adaptive_surface *surface = adaptive_sphere(6, center, radius);
    tf_adaptive_surface *same = adaptive_sphere(6, center, radius);
    tf_flow *flow = flow_of(surface), *other = flow_of(same);
    tf_flow_options options = {
        .edge = 0.03, .velocity = tf_field_apply, .context = &vortices};
    for (int i = 0; i < 20; i++) {
        ck_assert_int_eq(
            tf_flow_step(flow, 0.05 * i, 0.05, &options, NULL, NULL), TF_OK);
        ck_assert_int_eq(
            careless_step(other, 0, 0.05 * i, 0.05, &options, NULL), TF_OK);
    }
    expect_same(surface, same);
    tf_flow_free(flow);
    tf_flow_free(other);
    tf_adaptive_free(surface);
    tf_adaptive_free(same);
}
END_TEST

// Topology --------------------------------------------------------------------

/// Towards the plane x = 0.
static void approach(void *context, double time, int points,
                     const double point[], const double normal[],
                     double velocity[])
{
    (void)context, (void)time, (void)normal;
    for (int i = 0; i < points; i++) {
        velocity[3 * i] = point[3 * i] < 0 ? 1 : -1;
        velocity[3 * i + 1] = velocity[3 * i + 2] = 0;
    }
}

/// Two spheres of one surface.
static tf_adaptive_surface *two_spheres(void)
{
    static const double left[] = {-1.2, 0, 0};
    static double position[2000][3];
    static int triangle[6000];
    tf_adaptive_surface *one = adaptive_sphere(5, left, 1);
    tf_mesh mesh = *tf_adaptive_mesh(one);
    for (int v = 0; v < mesh.vertices; v++)
        for (int k = 0; k < 3; k++) {
            double x = coordinates_of(one, v)[k];
            position[v][k] = x;
            position[mesh.vertices + v][k] = x + (k == 0 ? 2.4 : 0);
        }
    for (int i = 0; i < 3 * mesh.triangles; i++) {
        triangle[i] = mesh.triangle[i];
        triangle[3 * mesh.triangles + i] = mesh.triangle[i] + mesh.vertices;
    }
    tf_adaptive_surface *both =
        adaptive_of(2 * mesh.vertices, position, 2 * mesh.triangles, triangle);
    tf_adaptive_free(one);
    return both;
}

/// Lets two spheres meet; returns how many times they merged.
static size_t meet(bool keep_topology)
{
    tf_adaptive_surface *surface = two_spheres();
    tf_flow *flow = flow_of(surface);
    tf_flow_options options = {
        .edge = 0.3, .velocity = approach, .keep_topology = keep_topology};
    size_t merges = 0;
    for (int i = 0; i < 20; i++) {
        const tf_flow_report *report;
        ck_assert_int_eq(tf_flow_step(flow, 0, 0.02, &options, &report, NULL),
                         TF_OK);
        expect_embedded(surface);
        merges += report->reconnected->tried[TF_MERGE][TF_COMMITTED];
    }
    tf_flow_free(flow);
    tf_adaptive_free(surface);
    return merges;
}

START_TEST(spheres_that_meet_merge_if_they_may)
{
    ck_assert_uint_ge(meet(false), 1);
    ck_assert_uint_eq(meet(true), 0);
}
END_TEST

START_TEST(small_components_vanish)
{
    tf_adaptive_surface *surface = adaptive_tetrahedron();
    tf_flow *flow = flow_of(surface);
    tf_flow_options options = {.edge = 6, .velocity = approach};
    for (int i = 0; i < 2; i++) {
        const tf_flow_report *report;
        ck_assert_int_eq(tf_flow_step(flow, 0, 0.1, &options, &report, NULL),
                         TF_OK);
        ck_assert_int_eq(surface->triangles, 0);
        ck_assert_uint_eq(report->reconnected->tried[TF_DROP][TF_COMMITTED],
                          i == 0);
    }
    tf_flow_free(flow);
    tf_adaptive_free(surface);
}
END_TEST

// All or nothing --------------------------------------------------------------

/// A flow in growth, whose context is a cancellation.
static void grow(void *context, double time, int points, const double point[],
                 const double normal[], double velocity[])
{
    (void)context, (void)time, (void)point;
    for (int i = 0; i < 3 * points; i++)
        velocity[i] = normal[i];
}

static tf_adaptive_surface *bumpy(void)
{
    return adaptive_bumpy_sphere(6, 0.03, 1);
}

/// Makes a step into contacts; with the flow of an earlier call, if that was
/// cancelled, so that its memory is used again.
static tf_status step(tf_adaptive_surface *surface, cancellation *cancelling,
                      tf_error *error)
{
    static tf_flow *flow;
    static int workers = 2;
    tf_parallel parallel = scrambled_workers(&workers);
    const tf_flow_options options = {.edge = 0.25,
                                     .velocity = grow,
                                     .parallel = &parallel,
                                     .progress = tell_cancellation,
                                     .context = cancelling};
    if (!flow || cancelling->last > 0)
        flow = flow_of(surface);
    tf_status status = tf_flow_step(flow, 0, -0.4, &options, NULL, error);
    if (status == TF_OK) {
        tf_flow_free(flow);
        flow = NULL;
    }
    return status;
}

START_TEST(a_cancelled_step_changes_nothing)
{
    expect_cancelling(bumpy, step, cases(60));
}
END_TEST

START_TEST(a_step_that_fails_changes_nothing)
{
    tf_adaptive_surface *surface = bumpy();
    tf_flow *flow = flow_of(surface);
    tf_flow_options options = {.edge = 0.25, .velocity = grow};
    uint64_t before = adaptive_hash(surface);
    tf_error error;
    ck_assert_int_eq(tf_flow_step(flow, 0, INFINITY, &options, NULL, &error),
                     TF_NOT_FINITE);
    ck_assert_int_eq(error.status, TF_NOT_FINITE);
    ck_assert_int_eq(error.subject, TF_NO_SUBJECT); // the numbers are others
    ck_assert_uint_eq(adaptive_hash(surface), before);
    ck_assert_int_eq(tf_flow_step(flow, 0, 0.01, &options, NULL, &error),
                     TF_OK);
    ck_assert_uint_ne(adaptive_hash(surface), before);
    tf_flow_free(flow);
    tf_adaptive_free(surface);
}
END_TEST

// Arguments -------------------------------------------------------------------

START_TEST(bad_lengths_are_refused)
{
    static const double edges[] = {0, -1, NAN, INFINITY};
    tf_adaptive_surface *surface = adaptive_tetrahedron();
    tf_flow *flow = flow_of(surface);
    for (int i = 0; i < 4; i++) {
        tf_flow_options options = {
            .edge = edges[i], .velocity = tf_field_apply, .context = &vortices};
        tf_error error;
        ck_assert_int_eq(tf_flow_step(flow, 0, 1, &options, NULL, &error),
                         TF_BAD_OPTION);
        ck_assert_str_eq(error.option, "edge");
    }
    tf_flow_free(flow);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(what_is_left_alone_does_not_flow)
{
    static const double position[] = {0, 0, 0, 1, 0, 0, 2, 0, 0};
    static const int triangle[] = {0, 1, 2};
    tf_mesh mesh = {
        .axes = 3, .vertices = 3, .triangles = 1, .triangle = triangle};
    tf_adaptive_surface *surface = NULL;
    ck_assert_int_eq(
        tf_adaptive_create_around(&mesh, position, &surface, NULL, NULL),
        TF_OK);
    tf_flow *flow = flow_of(surface);
    tf_flow_options options = {
        .edge = 1, .velocity = tf_field_apply, .context = &vortices};
    tf_error error;
    ck_assert_int_eq(tf_flow_step(flow, 0, 1, &options, NULL, &error),
                     TF_COLLINEAR);
    ck_assert_uint_eq(error.index, 0);
    tf_flow_free(flow);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(bad_options_are_refused)
{
    tf_adaptive_surface *surface = adaptive_tetrahedron();
    tf_flow *flow = flow_of(surface);
    int workers = 1;
    tf_parallel parallel = scrambled_workers(&workers);
    parallel.workers = 0;
    const tf_flow_options bad[] = {
        {.size = 8, .edge = 1, .velocity = approach},
        {.edge = 1, .velocity = approach, .parallel = &parallel}};
    static const char *const names[] = {"size", "parallel.workers"};
    for (int i = 0; i < 2; i++) {
        tf_error error;
        ck_assert_int_eq(tf_flow_step(flow, 0, 1, &bad[i], NULL, &error),
                         TF_BAD_OPTION);
        ck_assert_str_eq(error.option, names[i]);
    }
    tf_flow_free(flow);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(a_flow_needs_a_velocity)
{
    tf_flow_options options = {.edge = 1};
    tf_flow_step(flow_of(adaptive_tetrahedron()), 0, 1, &options, NULL, NULL);
}
END_TEST

START_TEST(freeing_no_flow_does_nothing)
{
    tf_flow_free(NULL);
}
END_TEST

static double count_calls(void *context)
{
    return ++*(int *)context;
}

/// As `approach`, with a count as its context.
static void approach_by_clock(void *context, double time, int points,
                              const double point[], const double normal[],
                              double velocity[])
{
    ck_assert_int_ge(*(int *)context, 3);
    approach(context, time, points, point, normal, velocity);
}

START_TEST(the_report_has_times_by_a_clock)
{
    tf_adaptive_surface *surface = adaptive_tetrahedron();
    tf_flow *flow = flow_of(surface);
    int calls = 0;
    tf_flow_options options = {.edge = 2,
                               .velocity = approach_by_clock,
                               .clock = count_calls,
                               .context = &calls};
    const tf_flow_report *report;
    ck_assert_int_eq(tf_flow_step(flow, 0, 0, &options, &report, NULL), TF_OK);
    for (int i = 0; i < TF_FLOW_PARTS; i++)
        ck_assert_double_eq(report->seconds[i], i <= TF_ADVANCE);
    tf_flow_free(flow);
    tf_adaptive_free(surface);
}
END_TEST

static void along_the_normal(void *context, double time, int points,
                             const double point[], const double normal[],
                             double velocity[])
{
    (void)time;
    (void)point;
    for (int i = 0; i < 3 * points; i++)
        velocity[i] = 0.05 * *(const double *)context * normal[i];
}

/// Where a vertex of an octahedron is after three steps, in its unit of length.
static double grown_octahedron(double size, tf_status expected)
{
    static const int triangle[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4,
                                   2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    double x[18] = {size, 0,     0, -size, 0, 0,    0, size, 0,
                    0,    -size, 0, 0,     0, size, 0, 0,    -size};
    tf_mesh mesh = {
        .axes = 3, .vertices = 6, .triangles = 8, .triangle = triangle};
    tf_adaptive_surface *surface = NULL;
    ck_assert_int_eq(tf_adaptive_create(&mesh, x, &surface, NULL), TF_OK);
    tf_flow *flow = flow_of(surface);
    tf_flow_options options = {
        .edge = size / 2, .velocity = along_the_normal, .context = &size};
    for (int i = 0; i < 3; i++)
        ck_assert_int_eq(tf_flow_step(flow, 0, 1, &options, NULL, NULL),
                         expected);
    double radius_now = tf_adaptive_positions(surface)[0] / size;
    tf_flow_free(flow);
    tf_adaptive_free(surface);
    return radius_now;
}

START_TEST(any_unit_of_length_will_do)
{
    double one = grown_octahedron(1, TF_OK);
    for (int k = -300; k <= 75; k += 5)
        ck_assert_double_eq_tol(grown_octahedron(pow(10, k), TF_OK), one,
                                1e-12 * one);
    for (int k = 80; k <= 300; k += 5)
        ck_assert_double_eq(grown_octahedron(pow(10, k), TF_OUT_OF_RANGE), 1);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("flow/flow");
    TCase *tcase = tcase_create("there and back");
    tcase_add_test(tcase, a_ball_returns_from_vortices_with_its_volume);
    tcase_add_test(tcase, workers_change_no_bit);
    tcase_add_test(tcase, a_flow_remembers_nothing_of_its_steps);
    tcase_add_test(tcase, a_step_is_its_parts);
    suite_add_tcase(suite, tcase);
    tcase = tcase_create("topology");
    tcase_add_test(tcase, spheres_that_meet_merge_if_they_may);
    tcase_add_test(tcase, small_components_vanish);
    tcase_add_test(tcase, any_unit_of_length_will_do);
    suite_add_tcase(suite, tcase);
    tcase = tcase_create("all or nothing");
    tcase_add_test(tcase, a_cancelled_step_changes_nothing);
    tcase_add_test(tcase, a_step_that_fails_changes_nothing);
    suite_add_tcase(suite, tcase);
    tcase = tcase_create("arguments");
    tcase_add_test(tcase, bad_lengths_are_refused);
    tcase_add_test(tcase, what_is_left_alone_does_not_flow);
    tcase_add_test(tcase, bad_options_are_refused);
    tcase_add_test_raise_signal(tcase, a_flow_needs_a_velocity, SIGABRT);
    tcase_add_test(tcase, freeing_no_flow_does_nothing);
    tcase_add_test(tcase, the_report_has_times_by_a_clock);
    suite_add_tcase(suite, tcase);
    return suite;
}
