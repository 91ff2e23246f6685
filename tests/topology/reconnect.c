// Reconnecting whole scenes: what meets becomes one, and what gets thin becomes
// two.
#include "topology/reconnect.h"

#include "support/adaptive_surfaces.h"
#include "support/blobs.h"
#include "support/cancelling.h"
#include "support/support.h"
#include "surgery/collapse.h"
#include "surgery/move.h"
#include "surgery/split.h"

#include <math.h>

static blobs made;
static tf_reconnect_report report; ///< the sum of all

static void reconnect(tf_adaptive_surface *surface, double edge)
{
    tf_reconnect_options how = {.edge = edge};
    const tf_reconnect_report *own;
    ck_assert_int_eq(tf_adaptive_reconnect(surface, &how, &own, NULL), TF_OK);
    for (int i = 0; i < TF_RECONNECTIONS; i++) {
        report.gained[i] += own->gained[i];
        for (int j = 0; j < TF_OUTCOMES; j++)
            report.tried[i][j] += own->tried[i][j];
    }
}

static size_t done(tf_reconnection what)
{
    return report.tried[what][TF_COMMITTED];
}

/// Moves each vertex by what `way` says, if that is possible.
static void move_all(tf_adaptive_surface *surface,
                     void (*way)(const double from[3], double to[3]))
{
    int vertices = tf_adaptive_mesh(surface)->vertices;
    for (int v = 0; v < vertices; v++) {
        double to[3];
        tf_outcome outcome;
        way(coordinates_of(surface, v), to);
        ck_assert_int_eq(tf_adaptive_move(surface, v, to, &outcome), TF_OK);
    }
}

// Balls -----------------------------------------------------------------------

enum {
    DIVISIONS = 6
};

static const double ball_edge = 1.9 / DIVISIONS; // the mean

/// Towards the plane between, up to some distance.
static void press(const double from[3], double to[3])
{
    for (int k = 0; k < 3; k++)
        to[k] = from[k];
    to[0] += from[0] < 0 ? 0.02 : -0.02;
}

static tf_adaptive_surface *make_balls(uint64_t stream)
{
    generator random = generator_new(stream);
    made.vertices = made.triangles = 0;
    for (int i = 0; i < 2; i++) {
        double middle[] = {i ? 1.06 : -1.06, uniform(&random, -0.25, 0.25),
                           uniform(&random, -0.25, 0.25)};
        add_ball(&made, middle, 1, DIVISIONS);
    }
    return blobs_surface(&made);
}

/// Presses balls together, and reconnects from some step on.
static void meet(tf_adaptive_surface *surface, int steps, int from)
{
    report = (tf_reconnect_report){0};
    for (int i = 0; i < steps; i++) {
        move_all(surface, press);
        if (i < from)
            continue;
        reconnect(surface, ball_edge);
        ck_assert(is_sound(surface));
    }
}

START_TEST(two_balls_that_meet_become_one)
{
    tf_adaptive_surface *surface = make_balls((uint64_t)_i);
    meet(surface, 12, 0);
    ck_assert_uint_eq(done(TF_MERGE), 1);
    ck_assert_int_eq(parts_of(surface), 1);
    ck_assert_int_eq(euler_of(surface), 2);
    ck_assert_double_gt(report.gained[TF_MERGE], 0);
    tf_adaptive_free(surface);
}
END_TEST

// Where they are pressed together there is much that could merge.
START_TEST(one_contact_makes_one_merge)
{
    tf_adaptive_surface *surface = make_balls(100 + (uint64_t)_i);
    meet(surface, 18, 14);
    ck_assert_uint_eq(done(TF_MERGE), 1);
    ck_assert_int_eq(euler_of(surface), 2);
    tf_adaptive_free(surface);
}
END_TEST

// Four balls in a ring meet in four places: that makes a handle.
START_TEST(a_ring_of_balls_gets_one_handle)
{
    static const double way[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    made.vertices = made.triangles = 0;
    for (int i = 0; i < 4; i++) {
        double middle[] = {1.42 * way[i][0], 1.42 * way[i][1], 0.03 * i};
        add_ball(&made, middle, 1, 12);
    }
    tf_adaptive_surface *surface = blobs_surface(&made);
    report = (tf_reconnect_report){0};
    for (int i = 0; i < 3; i++)
        reconnect(surface, 1.9 / 12);
    ck_assert_uint_eq(done(TF_MERGE), 4);
    ck_assert_int_eq(parts_of(surface), 1);
    ck_assert_int_eq(euler_of(surface), 0);
    ck_assert(is_sound(surface));
    tf_adaptive_free(surface);
}
END_TEST

// A dumbbell ------------------------------------------------------------------

static const double dumbbell_edge = 0.22;

static tf_adaptive_surface *make_dumbbell(void)
{
    enum {
        RINGS = 25
    };
    double radius[RINGS], height[RINGS];
    for (int i = 0; i < RINGS; i++) {
        double z = -1.95 + 3.9 * i / (RINGS - 1), from = fabs(z) - 1;
        double ball = from * from < 1 ? sqrt(1 - from * from) : 0;
        height[i] = z;
        radius[i] = fabs(z) < 1 ? fmax(0.4, ball) : ball;
    }
    made.vertices = made.triangles = 0;
    add_turned(&made, 16, RINGS, radius, height);
    return blobs_surface(&made);
}

/// In the middle towards the axis 2.
static void squeeze(const double from[3], double to[3])
{
    double z = from[2] / 0.4, factor = 1 - 0.1 * exp(-z * z);
    to[0] = factor * from[0];
    to[1] = factor * from[1];
    to[2] = from[2];
}

static double length_between(const double a[3], const double b[3])
{
    return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

/// Splits the long edges in the middle, and collapses the short ones there.
static void even_out(tf_adaptive_surface *surface)
{
    for (int c = 0; c < 3 * tf_adaptive_mesh(surface)->triangles; c++) {
        const int *t = tf_adaptive_mesh(surface)->triangle + c / 3 * 3;
        int from = t[c % 3], to = t[(c + 1) % 3], added;
        if (t[0] < 0)
            continue;
        const double *a = coordinates_of(surface, from),
                     *b = coordinates_of(surface, to);
        double length = length_between(a, b);
        const double middle[] = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2,
                                 (a[2] + b[2]) / 2};
        tf_outcome outcome;
        tf_status status = TF_OK;
        if (length > 1.5 * dumbbell_edge)
            status =
                tf_adaptive_split(surface, from, to, middle, &added, &outcome);
        else if (length < 0.5 * dumbbell_edge)
            status =
                tf_adaptive_collapse_to(surface, from, to, middle, &outcome);
        ck_assert_int_eq(status, TF_OK);
    }
}

// With every vertex of the neck left alone there is none to be pinched.
START_TEST(what_is_left_alone_is_not_reconnected)
{
    tf_adaptive_surface *surface = make_dumbbell();
    report = (tf_reconnect_report){0};
    for (int i = 0; i < 25; i++) {
        even_out(surface);
        move_all(surface, squeeze);
    }
    for (int v = 0; v < tf_adaptive_mesh(surface)->vertices; v++)
        adaptive_freeze(surface, v);
    reconnect(surface, dumbbell_edge);
    ck_assert_uint_eq(done(TF_PINCH), 0);
    ck_assert_uint_eq(done(TF_MERGE), 0);
    ck_assert_int_eq(parts_of(surface), 1);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(a_squeezed_dumbbell_becomes_two_balls)
{
    tf_adaptive_surface *surface = make_dumbbell();
    report = (tf_reconnect_report){0};
    for (int i = 0; i < 25; i++) {
        even_out(surface);
        reconnect(surface, dumbbell_edge);
        ck_assert(is_sound(surface));
        move_all(surface, squeeze);
    }
    ck_assert_int_eq(parts_of(surface), 2);
    ck_assert_int_eq(euler_of(surface), 4);
    ck_assert_uint_gt(done(TF_PINCH), 0);
    ck_assert_uint_eq(done(TF_DROP) + 1, done(TF_PINCH));
    tf_adaptive_free(surface);
}
END_TEST

// All or nothing --------------------------------------------------------------

static tf_adaptive_surface *scaled_dumbbell_and_balls(int exponent)
{
    made.vertices = made.triangles = 0;
    for (int i = 0; i < 3; i++) {
        const double middle[] = {i < 2 ? 2.03 * i : 9, 0.1 * i, 0};
        add_ball(&made, middle, i < 2 ? 1 : 0.1, DIVISIONS);
    }
    static const double radius[] = {1, 1, 0.1, 1, 1},
                        height[] = {10, 11, 12, 13, 14};
    add_turned(&made, 3, 5, radius, height);
    for (int i = 0; i < 3 * made.vertices; i++) {
        double *x = &made.position[i / 3][i % 3];
        *x = ldexp(*x, exponent);
    }
    return blobs_surface(&made);
}

static tf_adaptive_surface *dumbbell_and_balls(void)
{
    return scaled_dumbbell_and_balls(0);
}

static tf_status reconnect_all(tf_adaptive_surface *surface,
                               cancellation *cancelling, tf_error *error)
{
    const tf_reconnect_options how = {.edge = ball_edge,
                                      .progress = tell_cancellation,
                                      .context = cancelling};
    const tf_reconnect_report *own;
    tf_status status = tf_adaptive_reconnect(surface, &how, &own, error);
    for (int i = 0; i < 3 && status == TF_OK; i++)
        ck_assert_uint_eq(own->tried[i][TF_COMMITTED], 1);
    return status;
}

START_TEST(a_cancelled_reconnection_changes_nothing)
{
    expect_cancelling(dumbbell_and_balls, reconnect_all, cases(100));
}
END_TEST

// Scales ----------------------------------------------------------------------

static tf_adaptive_surface *reconnected(int exponent, double gained[3])
{
    tf_adaptive_surface *surface = scaled_dumbbell_and_balls(exponent);
    tf_reconnect_options how = {.edge = ldexp(ball_edge, exponent)};
    const tf_reconnect_report *own;
    ck_assert_int_eq(tf_adaptive_reconnect(surface, &how, &own, NULL), TF_OK);
    for (int i = 0; i < 3; i++) {
        ck_assert_uint_eq(own->tried[i][TF_COMMITTED], 1);
        gained[i] = own->gained[i];
    }
    ck_assert_int_eq(tf_adaptive_compact(surface, NULL), TF_OK);
    return surface;
}

// The least coordinates are about 2^-57 beside 1.
START_TEST(the_unit_of_length_changes_no_bit)
{
    double gained[3], others[3];
    tf_adaptive_surface *one = reconnected(0, gained);
    tf_mesh mesh = *tf_adaptive_mesh(one);
    const double *x = tf_adaptive_positions(one);
    for (int k = -950; k <= 240; k += 70) {
        tf_adaptive_surface *other = reconnected(k, others);
        for (int i = 0; i < 3; i++)
            ck_assert_double_eq(others[i], ldexp(gained[i], 3 * k));
        tf_mesh same = *tf_adaptive_mesh(other);
        ck_assert_int_eq(same.vertices, mesh.vertices);
        ck_assert_int_eq(same.triangles, mesh.triangles);
        ck_assert_mem_eq(same.triangle, mesh.triangle,
                         3 * sizeof(int) * (size_t)mesh.triangles);
        for (int i = 0; i < 3 * mesh.vertices; i++)
            ck_assert_double_eq(tf_adaptive_positions(other)[i],
                                ldexp(x[i], k));
        tf_adaptive_free(other);
    }
    tf_adaptive_free(one);
}
END_TEST

// An infinite one is as good as one that reaches everywhere.
START_TEST(lengths_may_overflow)
{
    for (int k = -1000; k <= 240; k += 40) {
        tf_adaptive_surface *surface = scaled_dumbbell_and_balls(k);
        for (int sign = -1; sign < 2; sign++) {
            tf_reconnect_options how = {.edge = 1e308,
                                        .merge = 10 * sign,
                                        .patch = sign,
                                        .pinch = sign,
                                        .drop = sign};
            ck_assert_int_eq(tf_adaptive_reconnect(surface, &how, NULL, NULL),
                             TF_OK);
            int left = sign < 0 ? 4 : 0;
            ck_assert_int_eq(parts_of(surface), left);
        }
        tf_adaptive_free(surface);
    }
}
END_TEST

// -----------------------------------------------------------------------------

START_TEST(invalid_options_are_rejected)
{
    tf_adaptive_surface *surface = adaptive_tetrahedron();
    tf_reconnect_options how[] = {{.edge = 0},
                                  {.edge = INFINITY},
                                  {.edge = 1, .merge = INFINITY},
                                  {.edge = 1, .patch = NAN},
                                  {.edge = 1, .pinch = -INFINITY},
                                  {.edge = 1, .drop = INFINITY},
                                  {.edge = 1, .size = 8}};
    static const char *const names[] = {"edge",  "edge", "merge", "patch",
                                        "pinch", "drop", "size"};
    for (size_t i = 0; i < sizeof how / sizeof *how; i++) {
        tf_error error;
        ck_assert_int_eq(tf_adaptive_reconnect(surface, &how[i], NULL, &error),
                         TF_BAD_OPTION);
        ck_assert_int_eq(error.status, TF_BAD_OPTION);
        ck_assert_str_eq(error.option, names[i]);
    }
    tf_adaptive_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("topology/reconnect");
    TCase *tcase = tcase_create("reconnections");
    tcase_add_loop_test(tcase, two_balls_that_meet_become_one, 0, 10);
    tcase_add_loop_test(tcase, one_contact_makes_one_merge, 0, 10);
    tcase_add_test(tcase, a_ring_of_balls_gets_one_handle);
    tcase_add_test(tcase, a_squeezed_dumbbell_becomes_two_balls);
    tcase_add_test(tcase, what_is_left_alone_is_not_reconnected);
    tcase_add_test(tcase, a_cancelled_reconnection_changes_nothing);
    tcase_add_test(tcase, the_unit_of_length_changes_no_bit);
    tcase_add_test(tcase, lengths_may_overflow);
    tcase_add_test(tcase, invalid_options_are_rejected);
    suite_add_tcase(suite, tcase);
    return suite;
}
