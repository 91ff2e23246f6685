// The largest clear fraction of a step.
#include "response/limit.h"

#include "fast/detect.h"
#include "response/resolve.h"
#include "support/proposals.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "surface/surface_memory.h"

#include <float.h>
#include <math.h>
#include <signal.h>
#include <string.h>

static proposal made;
static tf_surface *surface;
static tf_resolver *resolver;

static void begin(void)
{
    surface = surface_of(&made.mesh);
    ck_assert_int_eq(tf_resolver_create(surface, &resolver), TF_OK);
}

static void finish(void)
{
    tf_resolver_free(resolver);
    tf_surface_free(surface);
}

static bool is_clear(const double *end)
{
    tf_motion motion = {made.mesh.axes, made.mesh.vertices, made.start, end};
    tf_contacts found;
    ck_assert_int_eq(tf_surface_detect(surface, &motion, NULL, &found, NULL),
                     TF_OK);
    return !found.any;
}

static void fraction(int halvings, double *end)
{
    for (int i = 0; i < made.mesh.axes * made.mesh.vertices; i++)
        end[i] = made.start[i] +
                 ldexp(made.end[i] / 2 - made.start[i] / 2, 1 - halvings);
}

/// Expects the step to be limited as trying one fraction after another does.
static int expect_limited(void)
{
    static double expected[3 * PROPOSAL_VERTICES], end[3 * PROPOSAL_VERTICES];
    size_t bytes =
        sizeof(double) * (size_t)made.mesh.axes * (size_t)made.mesh.vertices;
    int halvings = 99, least = 0;
    memcpy(expected, made.end, bytes);
    while (!is_clear(expected))
        fraction(++least, expected);
    memcpy(end, made.end, bytes);
    ck_assert_int_eq(tf_step_limit(resolver, made.mesh.vertices, made.start,
                                   end, NULL, &halvings, NULL),
                     TF_OK);
    ck_assert_mem_eq(end, expected, bytes);
    if (memcmp(expected, made.start, bytes) == 0)
        ck_assert_int_eq(halvings, least == 0 ? 0 : -1);
    else
        ck_assert_int_eq(halvings, least);
    return halvings;
}

START_TEST(fractions_are_the_largest_clear_ones)
{
    generator random = generator_new(100 + (uint64_t)_i);
    const int all = 50;
    int halved = 0;
    for (int i = 0; i < cases(all) || (halved == 0 && i < all); i++) {
        proposal_make(&random, (proposal_shape)_i, 1,
                      (proposal_way)below(&random, PROPOSAL_WAYS), &made);
        begin();
        halved += expect_limited() > 0;
        finish();
    }
    ck_assert_int_gt(halved, 0);
}
END_TEST

/// A speck `gap` above an edge, falling by `fall`.
static void make_speck(double gap, double fall)
{
    proposal_begin(&made, 2);
    proposal_add_edge(&made, proposal_add_vertex(&made, -1, 0, 0),
                      proposal_add_vertex(&made, 1, 0, 0));
    proposal_add_vertex(&made, 0, gap, 0);
    made.end[5] -= fall;
    begin();
}

START_TEST(halvings_are_those_by_hand)
{
    make_speck(1, 0.5);
    ck_assert_int_eq(expect_limited(), 0);
    finish();
    make_speck(1, 1); // touches at the end
    ck_assert_int_eq(expect_limited(), 1);
    finish();
    make_speck(1, 7);
    ck_assert_int_eq(expect_limited(), 3);
    finish();
}
END_TEST

// Above the edge by the least number, it cannot move.
START_TEST(no_motion_may_be_left)
{
    make_speck(0x1p-1074, 1);
    ck_assert_int_eq(expect_limited(), -1);
    finish();
}
END_TEST

START_TEST(differences_may_overflow)
{
    make_speck(DBL_MAX, 0);
    made.end[5] = -DBL_MAX;
    ck_assert_int_eq(expect_limited(), 2);
    finish();
}
END_TEST

static bool go_on(void *context, const tf_stage *stage)
{
    (void)context, (void)stage;
    return true;
}

// What was resolved before is forgotten, and so is who was told of it.
START_TEST(nothing_is_resolved)
{
    tf_response_options options = {.progress = go_on};
    const tf_answered_contact *contact;
    double end[6];
    int halvings;
    size_t count;
    make_speck(1, 7);
    memcpy(end, made.end, sizeof end);
    ck_assert_int_eq(tf_step_resolve(resolver, 3, made.start, end, NULL,
                                     &options, NULL, NULL),
                     TF_OK);
    ck_assert_int_eq(tf_resolver_contacts(resolver, &count, &contact), TF_OK);
    ck_assert_uint_gt(count, 0);
    ck_assert_ptr_nonnull(tf_resolver_unpushed(resolver));
    ck_assert_int_eq(tf_step_limit(resolver, 3, made.start, made.end, &options,
                                   &halvings, NULL),
                     TF_OK);
    ck_assert_int_eq(tf_resolver_contacts(resolver, &count, &contact), TF_OK);
    ck_assert_uint_eq(count, 0);
    ck_assert_ptr_null(tf_resolver_unpushed(resolver));
    ck_assert_ptr_null(surface->workers.watch);
    finish();
}
END_TEST

START_TEST(touching_starts_are_rejected)
{
    tf_error error;
    int halvings = 7;
    make_speck(0, 1);
    double end[6];
    memcpy(end, made.end, sizeof end);
    ck_assert_int_eq(
        tf_step_limit(resolver, 3, made.start, end, NULL, &halvings, &error),
        TF_START_NOT_CLEAR);
    ck_assert_int_eq(error.subject, TF_POINT_EDGE_PAIR);
    ck_assert_int_eq(error.vertex[0], 2);
    ck_assert_int_eq(halvings, 7);
    ck_assert_mem_eq(end, made.end, sizeof end);
    finish();
}
END_TEST

// Two edges that cross, and go on doing so: no contact tells.
START_TEST(crossed_starts_are_rejected_where_they_are_checked)
{
    tf_response_options check = {.check_start = true};
    tf_error error;
    int halvings = 7;
    proposal_begin(&made, 2);
    proposal_add_edge(&made, proposal_add_vertex(&made, -1, 0, 0),
                      proposal_add_vertex(&made, 1, 0, 0));
    proposal_add_edge(&made, proposal_add_vertex(&made, 0, -1, 0),
                      proposal_add_vertex(&made, 0, 1, 0));
    begin();
    ck_assert_int_eq(tf_step_limit(resolver, 4, made.start, made.end, &check,
                                   &halvings, &error),
                     TF_START_NOT_CLEAR);
    ck_assert_int_eq(error.subject, TF_EDGE_EDGE_PAIR);
    ck_assert_int_eq(halvings, 7);
    ck_assert_int_eq(expect_limited(), 0);
    finish();
}
END_TEST

START_TEST(bad_input_is_reported)
{
    tf_error error;
    int halvings;
    make_speck(1, 1);
    ck_assert_int_eq(
        tf_step_limit(resolver, 2, made.start, made.end, NULL, &halvings, NULL),
        TF_BAD_COUNT);
    made.end[3] = NAN;
    ck_assert_int_eq(tf_step_limit(resolver, 3, made.start, made.end, NULL,
                                   &halvings, &error),
                     TF_NOT_FINITE);
    ck_assert_int_eq(error.subject, TF_VERTEX);
    ck_assert_uint_eq(error.index, 1);
    finish();
}
END_TEST

// Two edges that cross and go apart, and a speck that falls upon a third one:
// the last pair alone limits the step.
START_TEST(what_is_in_a_zone_limits_nothing)
{
    static const int zone[] = {5, 5, -1};
    tf_response_options check = {
        .size = sizeof check, .check_start = true, .zone = zone};
    int halvings = 7;
    proposal_begin(&made, 2);
    for (int i = 0; i < 2; i++)
        proposal_add_edge(&made, proposal_add_vertex(&made, i - 1, -i, 0),
                          proposal_add_vertex(&made, 1 - i, i, 0));
    proposal_add_edge(&made, proposal_add_vertex(&made, 8, 0, 0),
                      proposal_add_vertex(&made, 10, 0, 0));
    proposal_add_vertex(&made, 9, 1, 0);
    made.end[1] = made.end[3] = 7;
    made.end[13] = -2;
    begin();
    ck_assert_int_eq(tf_step_limit(resolver, 7, made.start, made.end, &check,
                                   &halvings, NULL),
                     TF_OK);
    ck_assert_int_eq(halvings, 2);
    ck_assert_ptr_null(surface->zone[0]);
    check.zone = NULL;
    ck_assert_int_eq(tf_step_limit(resolver, 7, made.start, made.end, &check,
                                   &halvings, NULL),
                     TF_START_NOT_CLEAR);
    finish();
}
END_TEST

START_TEST(null_breaks_the_contract)
{
    double x = 0;
    tf_step_limit(NULL, 1, &x, &x, NULL, NULL, NULL);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("response/limit");
    TCase *tcase = tcase_create("fractions");
    tcase_add_loop_test(tcase, fractions_are_the_largest_clear_ones, 0,
                        PROPOSAL_SHAPES);
    tcase_add_test(tcase, halvings_are_those_by_hand);
    tcase_add_test(tcase, no_motion_may_be_left);
    tcase_add_test(tcase, differences_may_overflow);
    tcase_add_test(tcase, nothing_is_resolved);
    tcase_add_test(tcase, what_is_in_a_zone_limits_nothing);
    suite_add_tcase(suite, tcase);

    TCase *bad = tcase_create("trouble");
    tcase_add_test(bad, touching_starts_are_rejected);
    tcase_add_test(bad, crossed_starts_are_rejected_where_they_are_checked);
    tcase_add_test(bad, bad_input_is_reported);
    tcase_add_test_raise_signal(bad, null_breaks_the_contract, SIGABRT);
    suite_add_tcase(suite, bad);
    return suite;
}
