// All vertices move along a velocity, as far as nothing is in their way.
#include "flow/advance.h"

#include "support/adaptive_surfaces.h"
#include "support/flows.h"
#include "support/support.h"

#include <math.h>
#include <string.h>

static const double pi = 3.141592653589793, origin[3];

/// Advances a surface once by a velocity.
static tf_status advance(tf_adaptive_surface *surface,
                         tf_flow_velocity *velocity, double step, bool careless,
                         tf_response_report *report)
{
    tf_flow_advance all = {.surface = surface};
    const tf_flow_options options = {.edge = 0.3, .velocity = velocity};
    ck_assert_int_eq(tf_advance_begin(&all, &options, 0, step), TF_OK);
    ck_assert_int_eq(tf_advance_propose(&all), TF_OK);
    if (!careless)
        ck_assert_int_eq(tf_advance_restore_volume(&all), TF_OK);
    const tf_response_report *lent;
    tf_status status = tf_advance_resolve(&all, &lent);
    if (status == TF_OK && report)
        *report = *lent;
    tf_advance_free(&all);
    return status;
}

// Fields ----------------------------------------------------------------------

/// Around the third axis, once in 1.
static void turn(void *context, double time, int points, const double point[],
                 const double normal[], double velocity[])
{
    (void)context, (void)time, (void)normal;
    for (int i = 0; i < points; i++) {
        velocity[3 * i] = -2 * pi * point[3 * i + 1];
        velocity[3 * i + 1] = 2 * pi * point[3 * i];
        velocity[3 * i + 2] = 0;
    }
}

START_TEST(vertices_follow_the_velocity)
{
    tf_adaptive_surface *sphere = adaptive_sphere(4, origin, 1);
    const double first[] = {coordinates_of(sphere, 0)[0],
                            coordinates_of(sphere, 0)[1]};
    tf_response_report report;
    ck_assert_int_eq(advance(sphere, turn, 1.0 / 8, false, &report), TF_OK);
    const double *now = coordinates_of(sphere, 0);
    ck_assert_double_eq_tol(now[0], (first[0] - first[1]) * sqrt(0.5), 4e-3);
    ck_assert_double_eq_tol(now[1], (first[0] + first[1]) * sqrt(0.5), 4e-3);
    ck_assert_uint_eq(report.contacts, 0);
    tf_adaptive_free(sphere);
}
END_TEST

START_TEST(a_step_back_in_time_returns_to_the_start)
{
    tf_adaptive_surface *sphere = adaptive_sphere(4, origin, 1);
    double before[3];
    memcpy(before, coordinates_of(sphere, 5), sizeof before);
    ck_assert_int_eq(advance(sphere, turn, 1.0 / 32, false, NULL), TF_OK);
    ck_assert_int_eq(advance(sphere, turn, -1.0 / 32, false, NULL), TF_OK);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(coordinates_of(sphere, 5)[k], before[k], 1e-4);
    tf_adaptive_free(sphere);
}
END_TEST

/// Along the normals, and the longer the later.
static void grow(void *context, double time, int points, const double point[],
                 const double normal[], double velocity[])
{
    (void)context, (void)point;
    for (int i = 0; i < 3 * points; i++)
        velocity[i] = 6 * time * normal[i];
}

START_TEST(normals_and_times_are_those_of_the_stages)
{
    tf_adaptive_surface *surface = adaptive_tetrahedron();
    ck_assert_int_eq(advance(surface, grow, 0.5, false, NULL), TF_OK);
    for (int i = 0; i < 12; i++)
        ck_assert_double_eq_tol(fabs(coordinates_of(surface, 0)[i]),
                                1 + 0.75 * sqrt(1.0 / 3), 1e-15);
    tf_adaptive_free(surface);
}
END_TEST

/// Without sources, and not linear.
static void bend(void *context, double time, int points, const double point[],
                 const double normal[], double velocity[])
{
    (void)context, (void)time, (void)normal;
    for (int i = 0; i < points; i++) {
        const double *x = point + 3 * i;
        velocity[3 * i] = x[0] * x[0];
        velocity[3 * i + 1] = -2 * x[0] * x[1];
        velocity[3 * i + 2] = x[0] * x[1];
    }
}

/// How much volume a sphere gains when it is bent.
static double gain_by_bending(bool careless)
{
    static const double center[] = {0.5, 0, 0};
    tf_adaptive_surface *sphere = adaptive_sphere(8, center, 1);
    mpq_t before;
    mpq_init(before);
    exact_volume(sphere, before);
    ck_assert_int_eq(advance(sphere, bend, 0.1, careless, NULL), TF_OK);
    double gained = volume_gained(sphere, before);
    mpq_clear(before);
    tf_adaptive_free(sphere);
    return fabs(gained);
}

START_TEST(what_chords_lose_is_restored)
{
    double careless = gain_by_bending(true);
    ck_assert_double_gt(careless, 1e-3);
    ck_assert_double_lt(gain_by_bending(false), careless / 10);
}
END_TEST

// Obstacles -------------------------------------------------------------------

/// What is to the left goes to the right, and what is to the right to the left.
static void collide(void *context, double time, int points,
                    const double point[], const double normal[],
                    double velocity[])
{
    (void)context, (void)time, (void)normal;
    memset(velocity, 0, sizeof *velocity * 3 * (size_t)points);
    for (int i = 0; i < points; i++)
        velocity[3 * i] = point[3 * i] < 0 ? 1 : -1;
}

/// A box of eight corners and, apart from it, a tetrahedron.
static tf_adaptive_surface *two_tetrahedra(void)
{
    static const int triangle[] = {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2,
                                   4, 5, 6, 4, 6, 7, 4, 7, 5, 5, 7, 6};
    static double position[][3] = {{3, 1, 1},   {3, -1, -1}, {1, 1, -1},
                                   {1, -1, 1},  {-1, 1, 1},  {-1, -1, -1},
                                   {-3, 1, -1}, {-3, -1, 1}};
    return adaptive_of(8, position, 8, triangle);
}

START_TEST(nothing_passes_through_what_is_in_the_way)
{
    tf_adaptive_surface *surface = two_tetrahedra();
    tf_response_report report;
    ck_assert_int_eq(advance(surface, collide, 6, false, &report), TF_OK);
    ck_assert_uint_gt(report.contacts, 0);
    expect_embedded(surface);
    tf_adaptive_free(surface);
}
END_TEST

// A triangle with a boundary all around could turn over in its plane.
START_TEST(an_isolated_triangle_stays)
{
    static const int triangle[] = {0, 1, 2};
    static double position[][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    tf_adaptive_surface *surface = adaptive_of(3, position, 1, triangle);
    ck_assert_int_eq(advance(surface, collide, 1, false, NULL), TF_OK);
    ck_assert_mem_eq(coordinates_of(surface, 0), position, sizeof position);
    tf_adaptive_free(surface);
}
END_TEST

static void explode(void *context, double time, int points,
                    const double point[], const double normal[],
                    double velocity[])
{
    (void)context, (void)time, (void)normal, (void)point;
    for (int i = 0; i < 3 * points; i++)
        velocity[i] = i == 7 ? NAN : 0;
}

START_TEST(a_velocity_that_is_no_number_moves_nothing)
{
    tf_adaptive_surface *surface = adaptive_tetrahedron();
    double before[12];
    memcpy(before, coordinates_of(surface, 0), sizeof before);
    ck_assert_int_eq(advance(surface, explode, 1, false, NULL), TF_NOT_FINITE);
    ck_assert_mem_eq(coordinates_of(surface, 0), before, sizeof before);
    tf_adaptive_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("flow/advance");
    TCase *tcase = tcase_create("fields");
    tcase_add_test(tcase, vertices_follow_the_velocity);
    tcase_add_test(tcase, a_step_back_in_time_returns_to_the_start);
    tcase_add_test(tcase, normals_and_times_are_those_of_the_stages);
    tcase_add_test(tcase, what_chords_lose_is_restored);
    suite_add_tcase(suite, tcase);
    tcase = tcase_create("obstacles");
    tcase_add_test(tcase, nothing_passes_through_what_is_in_the_way);
    tcase_add_test(tcase, an_isolated_triangle_stays);
    tcase_add_test(tcase, a_velocity_that_is_no_number_moves_nothing);
    suite_add_tcase(suite, tcase);
    return suite;
}
