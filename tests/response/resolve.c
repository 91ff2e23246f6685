// Steps resolved: what goes in, and what the report says.
#include "response/resolve.h"

#include "distance/distance.h"
#include "support/near_oracle.h"
#include "support/proposals.h"
#include "support/scrambled_workers.h"
#include "support/support.h"
#include "support/surface_of.h"

#include <float.h>
#include <math.h>
#include <signal.h>
#include <string.h>

static proposal made;
static double end[3 * PROPOSAL_VERTICES];
static tf_response_report report;
static tf_error error;

static tf_status try(int vertices, const tf_response_options *options)
{
    tf_surface *surface = surface_of(&made.mesh);
    tf_resolver *resolver;
    memcpy(end, made.end, sizeof end);
    ck_assert_int_eq(tf_resolver_create(surface, &resolver), TF_OK);
    const tf_response_report *lent;
    tf_status status =
        tf_step_resolve(resolver, vertices, made.start, end, made.inverse_mass,
                        options, &lent, &error);
    if (status == TF_OK)
        report = *lent;
    tf_resolver_free(resolver);
    tf_surface_free(surface);
    return status;
}

static void resolve(tf_response_options options)
{
    ck_assert_int_eq(try(made.mesh.vertices, &options), TF_OK);
}

/// In the plane: an edge of two vertices of inverse mass `below` upon which a
/// third one falls by 2 from a height of 1, to the side by 1.
static void make_fall(double below)
{
    proposal_begin(&made, 2);
    proposal_add_edge(&made, proposal_add_vertex(&made, -4, 0, 0),
                      proposal_add_vertex(&made, 4, 0, 0));
    proposal_add_vertex(&made, -0.5, 1, 0);
    made.inverse_mass[0] = made.inverse_mass[1] = below;
    made.end[4] += 1;
    made.end[5] -= 2;
}

// Trouble ---------------------------------------------------------------------

static void expect(tf_status expected, int vertices,
                   const tf_response_options *options)
{
    memset(&report, 0x55, sizeof report);
    tf_response_report before = report;
    ck_assert_int_eq(try(vertices, options), expected);
    ck_assert_mem_eq(end, made.end, sizeof end);
    ck_assert_mem_eq(&report, &before, sizeof report);
}

/// Options that are younger than version 1.0, and so need their size.
#define THRESHOLD(value)                                                       \
    {                                                                          \
        .size = sizeof(tf_response_options), .restitution = 0.75,              \
        .separation = -1, .restitution_threshold = (value)                     \
    }

START_TEST(options_out_of_range_are_refused)
{
    static const tf_response_options bad[] = {{.sweeps = -1},
                                              {.separation = NAN},
                                              {.separation = INFINITY},
                                              {.separation = -INFINITY},
                                              {.restitution = -0x1p-1074},
                                              {.restitution = 1.0000001},
                                              {.restitution = NAN},
                                              THRESHOLD(-0x1p-1074),
                                              THRESHOLD(NAN),
                                              THRESHOLD(INFINITY),
                                              {.friction = -1},
                                              {.friction = NAN},
                                              {.friction = INFINITY}};
    make_fall(0);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        expect(TF_BAD_OPTION, 3, &bad[i]);
}
END_TEST

START_TEST(options_at_the_ends_of_their_ranges_are_taken)
{
    make_fall(0);
    resolve((tf_response_options){.restitution = 1, .friction = DBL_MAX});
    make_fall(1);
    resolve((tf_response_options){.separation = DBL_MAX, .zone_rounds = 1});
    resolve((tf_response_options){
        .separation = -DBL_MAX, .sweeps = 1, .impulse_rounds = -1});
}
END_TEST

START_TEST(invalid_masses_are_rejected)
{
    static const double bad[] = {-1, -0x1p-1074, NAN, INFINITY, -INFINITY};
    make_fall(0);
    made.inverse_mass[1] = bad[_i];
    expect(TF_BAD_MASS, 3, NULL);
    ck_assert_int_eq(error.subject, TF_VERTEX);
    ck_assert_uint_eq(error.index, 1);
}
END_TEST

/// Friction of vertices is younger than version 1.0, too.
static tf_response_options friction_of(const double own[3])
{
    return (tf_response_options){.size = sizeof(tf_response_options),
                                 .separation = -1,
                                 .friction = 9,
                                 .vertex_friction = own};
}

START_TEST(invalid_friction_of_vertices_is_rejected)
{
    static const double bad[] = {-1, -0x1p-1074, NAN, INFINITY, -INFINITY};
    double own[] = {0, DBL_MAX, 1};
    tf_response_options options = friction_of(own);
    make_fall(0);
    own[_i % 3] = bad[_i];
    expect(TF_BAD_OPTION, 3, &options);
    ck_assert_str_eq(error.option, "vertex_friction");
    ck_assert_int_eq(error.subject, TF_VERTEX);
    ck_assert_uint_eq(error.index, (size_t)_i % 3);
    ck_assert_int_eq(error.vertex[0], _i % 3);
    options.size = 0;
    resolve(options);
}
END_TEST

START_TEST(masses_of_any_size_are_taken)
{
    static const double most[] = {0x1p-1074, 0x1p-1022, DBL_MAX, 1e300, -0.};
    make_fall(0);
    for (int i = 0; i < 5; i++)
        for (int j = 0; j < 5; j++) {
            made.inverse_mass[0] = most[i];
            made.inverse_mass[2] = most[j];
            resolve((tf_response_options){0});
        }
}
END_TEST

START_TEST(invalid_positions_are_rejected)
{
    make_fall(0);
    expect(TF_BAD_COUNT, 2, NULL);
    made.start[3] = INFINITY;
    expect(TF_NOT_FINITE, 3, NULL);
    ck_assert_uint_eq(error.index, 1);
    make_fall(0);
    made.end[5] = NAN;
    expect(TF_NOT_FINITE, 3, NULL);
    ck_assert_uint_eq(error.index, 2);
}
END_TEST

START_TEST(starts_that_are_not_clear_are_rejected)
{
    make_fall(0);
    made.start[5] = 0;
    expect(TF_START_NOT_CLEAR, 3, NULL);
    ck_assert_int_eq(error.subject, TF_POINT_EDGE_PAIR);
    ck_assert_int_eq(error.vertex[0], 2);
    ck_assert_int_eq(error.vertex[3], -1);

    // Crossed, and it stays so: no contact tells.
    make_fall(0);
    proposal_add_vertex(&made, 0, -1, 0);
    made.start[4] = made.end[4] = 0;
    made.end[5] = 1;
    proposal_add_edge(&made, 2, 3);
    resolve((tf_response_options){0});
    expect(TF_START_NOT_CLEAR, 4, &(tf_response_options){.check_start = true});
    ck_assert_int_eq(error.subject, TF_EDGE_EDGE_PAIR);
    ck_assert_int_eq(error.vertex[2], 2);
}
END_TEST

START_TEST(null_breaks_the_contract)
{
    tf_step_resolve(NULL, 3, end, end, NULL, NULL, NULL, NULL);
}
END_TEST

// Answers ---------------------------------------------------------------------

START_TEST(clear_steps_come_back_bit_for_bit)
{
    make_fall(0);
    made.end[4] = 0.1;
    made.end[5] = 0x1p-1074;
    made.end[0] = -0.;
    resolve((tf_response_options){.restitution = 1, .friction = 1});
    ck_assert_mem_eq(end, made.end, 6 * sizeof *end);
    ck_assert_uint_eq(report.first_contacts, 0);
    ck_assert_int_eq(report.moved, 0);
    ck_assert_uint_gt(report.statistics.candidates, 0);
}
END_TEST

START_TEST(a_fall_is_stopped_where_it_began)
{
    make_fall(0);
    resolve((tf_response_options){.separation = -1});
    // It comes no nearer than it was.
    ck_assert_double_eq_tol(end[5], 1, 1e-12);
    ck_assert_double_eq_tol(end[4], 0.5, 1e-12);
    ck_assert_mem_eq(end, made.end, 4 * sizeof *end);
    ck_assert_int_eq(report.moved, 1);
    ck_assert_int_eq(report.held, 0);
    ck_assert_uint_eq(report.first_contacts, 1);
    ck_assert_double_eq_tol(report.smallest_gap, 1, 1e-12);
    ck_assert_double_eq_tol(report.energy_before, 2.5, 1e-12);
    ck_assert_double_eq_tol(report.energy_after, 0.5, 1e-12);
}
END_TEST

START_TEST(restitution_reverses_the_approach)
{
    make_fall(0);
    resolve((tf_response_options){.separation = -1, .restitution = 0.75});
    ck_assert_double_eq_tol(end[5], 2.5, 1e-12);
    ck_assert_double_eq_tol(end[4], 0.5, 1e-12);
}
END_TEST

// It was to approach by 2.
START_TEST(slow_approaches_have_no_restitution)
{
    make_fall(0);
    resolve((tf_response_options)THRESHOLD(nextafter(2, 0)));
    ck_assert_double_eq_tol(end[5], 2.5, 1e-12);
    resolve((tf_response_options)THRESHOLD(nextafter(2, 3)));
    ck_assert_double_eq_tol(end[5], 1, 1e-12);
    resolve((tf_response_options)THRESHOLD(DBL_MAX));
    ck_assert_double_eq_tol(end[5], 1, 1e-12);
}
END_TEST

START_TEST(friction_slows_sliding)
{
    make_fall(0);
    resolve((tf_response_options){.separation = -1, .friction = 0.25});
    ck_assert_double_eq_tol(end[5], 1, 1e-12);
    ck_assert_double_eq_tol(end[4], 0, 1e-12);
    resolve((tf_response_options){.separation = -1, .friction = 9});
    ck_assert_double_eq_tol(end[4], -0.5, 1e-12);
}
END_TEST

// The vertex falls by 2, which is stopped, and to the side by 1.  Where it meets
// the edge, 7/16 of that are behind it.
START_TEST(vertices_have_their_own_friction)
{
    static const struct {
        double own[3], friction;
    } expected[] = {
        {{0.25, 0.25, 0.25}, 0.25},
        {{0, 0, 9}, 0},
        {{9, 9, 0}, 0},
        {{0.1875, 0.1875, 0.75}, 0.375},
        {{0.8, 0, 0.2}, 0.3}, // 9/16 of 0.8 and 7/16 of 0
        {{0, 0.8, 0.2}, 0.26457513110645905},
    };
    make_fall(0);
    made.start[0] = made.end[0] = -4;
    made.start[2] = made.end[2] = 4;
    made.start[4] = -1;
    made.end[4] = 0;
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        resolve(friction_of(expected[i].own));
        ck_assert_double_eq_tol(end[4], -2 * expected[i].friction, 1e-12);
        tf_response_options impulses = friction_of(expected[i].own);
        impulses.impulse_rounds = 5;
        impulses.zone_rounds = -1;
        resolve(impulses);
        ck_assert_double_eq_tol(end[4], -2 * expected[i].friction, 1e-12);
    }
}
END_TEST

// A quarter of what is missing to the separation, or to half of the way.
START_TEST(near_pairs_are_pushed_apart)
{
    make_fall(0);
    resolve((tf_response_options){.separation = 3});
    ck_assert_double_eq_tol(end[5], 1, 1e-12);
    made.end[5] = -9;
    resolve((tf_response_options){.separation = 3});
    ck_assert_double_eq_tol(end[5], 1.5, 1e-12);
    // The push has no energy: what is left is that of the way to the side.
    ck_assert_double_eq_tol(report.energy_after, 0.5, 1e-12);
    // The mean edge is 8, and 0.05 of it less than the gap.
    resolve((tf_response_options){0});
    ck_assert_double_eq_tol(end[5], 1, 1e-12);
    made.start[5] = 0.2;
    made.end[5] = -1;
    resolve((tf_response_options){0});
    ck_assert_double_eq_tol(end[5], 0.25, 1e-12);
}
END_TEST

/// Whether the fall is nearer to the edge than a length at the end.
static bool ends_nearer(double length)
{
    static const int vertex[] = {2, 0, 1};
    bool nearer;
    ck_assert_int_eq(
        tf_is_nearer(TF_POINT_EDGE, 3, end, vertex, length, &nearer), TF_OK);
    return nearer;
}

#define THICKNESS(value)                                                       \
    .size = sizeof(tf_response_options), .separation = -1, .thickness = (value)

START_TEST(pairs_end_at_the_thickness_that_they_start_at)
{
    make_fall(_i);
    made.end[5] = 0.0625;
    resolve((tf_response_options){.separation = -1});
    ck_assert_mem_eq(end, made.end, sizeof end);
    ck_assert(report.near == 0 && report.first_near == 0);
    resolve((tf_response_options){THICKNESS(0.5)});
    ck_assert(!ends_nearer(0.5) && report.first_near == 1);
    ck_assert(report.first_contacts == 0 && report.rounds[TF_FAILSAFE] == 0);
    // By the failsafe alone.
    resolve((tf_response_options){THICKNESS(0.5), .zone_rounds = -1});
    ck_assert(!ends_nearer(0.5) && report.rounds[TF_FAILSAFE] > 0);
    // By impulses.
    resolve((tf_response_options){THICKNESS(0.5), .impulse_rounds = 3});
    ck_assert(!ends_nearer(0.5) && report.rounds[TF_IMPULSES] > 0);
}
END_TEST

START_TEST(a_start_at_the_thickness_counts_to_the_last_bit)
{
    make_fall(0);
    made.end[5] = 0.0625;
    resolve((tf_response_options){THICKNESS(1)});
    ck_assert(!ends_nearer(1) && report.near_at_start == 0);
    ck_assert(report.moved == 1);
    resolve((tf_response_options){THICKNESS(1 + 0x1p-52)});
    ck_assert_uint_eq(report.near_at_start, 1);
    ck_assert_mem_eq(end, made.end, sizeof end);
    // What ends at the thickness is let be, and an ulp nearer is not.
    made.end[5] = 0.5;
    resolve((tf_response_options){THICKNESS(0.5)});
    ck_assert_int_eq(report.moved, 0);
    made.end[5] = 0.5 - 0x1p-54;
    resolve((tf_response_options){THICKNESS(0.5)});
    ck_assert(report.moved == 1 && !ends_nearer(0.5));
}
END_TEST

// A sheet that sinks while it slides across another one slides all the way: pairs
// that start side by side must be free to approach.
START_TEST(sheets_slide_at_their_thickness)
{
    proposal_begin(&made, 3);
    int below = proposal_add_sheet(&made, 5, 0);
    int above = proposal_add_sheet(&made, 5, 0.3);
    for (int v = below; v < above; v++)
        made.inverse_mass[v] = 0;
    for (int v = above; v < made.mesh.vertices; v++) {
        made.end[3 * v] += 0.4;
        made.end[3 * v + 1] += 0.3;
        made.end[3 * v + 2] -= 0.1;
    }
    resolve((tf_response_options){THICKNESS(0.25)});
    ck_assert(report.near > 0 && report.rounds[TF_FAILSAFE] == 0);
    for (int v = above; v < made.mesh.vertices; v++) {
        ck_assert_double_eq_tol(end[3 * v], made.end[3 * v], 0.01);
        ck_assert_double_eq_tol(end[3 * v + 1], made.end[3 * v + 1], 0.01);
        ck_assert(end[3 * v + 2] >= 0.25 && end[3 * v + 2] < 0.27);
    }
}
END_TEST

/// By all levels, by zones and the failsafe, or by the failsafe alone: each, or
/// with a TF_TEST_PERCENT below 100 one in turn.
START_TEST(wild_proposals_keep_a_thickness)
{
    int number = proposal_number(_i);
    generator random = generator_new((uint64_t)number);
    proposal_make(&random, (proposal_shape)(number / PROPOSAL_WAYS), 2,
                  (proposal_way)(number % PROPOSAL_WAYS), &made);
    double length = made.unit * uniform(&random, 0.05, 0.3);
    tf_surface *surface = surface_of(&made.mesh);
    int apart = cases(100) < 100 ? 3 : 1;
    for (int j = _i % apart; j < 3; j += apart) {
        resolve((tf_response_options){THICKNESS(length),
                                      .impulse_rounds = j == 0 ? 2 : 0,
                                      .zone_rounds = j == 2 ? -1 : 0});
        size_t near;
        near_oracle(surface, end, made.start, length, &near);
        ck_assert_msg(near == 0, "seed %llu, %zu pairs nearer than %a",
                      (unsigned long long)seed(), near, length);
        ck_assert_int_lt(report.rounds[TF_FAILSAFE], made.mesh.vertices);
    }
    static double alone[3 * PROPOSAL_VERTICES];
    int workers = 3;
    tf_parallel parallel = scrambled_workers(&workers);
    resolve((tf_response_options){THICKNESS(length)});
    memcpy(alone, end, sizeof alone);
    resolve((tf_response_options){THICKNESS(length), .parallel = &parallel});
    ck_assert_mem_eq(end, alone, sizeof alone);
    tf_surface_free(surface);
}
END_TEST

START_TEST(a_thickness_of_zero_changes_nothing)
{
    generator random = generator_new((uint64_t)_i);
    static double usual[3 * PROPOSAL_VERTICES];
    proposal_make(&random, SHEETS, 2, (proposal_way)_i, &made);
    resolve((tf_response_options){0});
    memcpy(usual, end, sizeof usual);
    resolve((tf_response_options){.size = sizeof(tf_response_options)});
    ck_assert_mem_eq(end, usual, sizeof end);
}
END_TEST

// The point is scripted to pass the edge, which is scripted to stay.
START_TEST(scripted_vertices_pass_each_other)
{
    make_fall(0);
    made.inverse_mass[2] = 0;
    resolve((tf_response_options){0});
    ck_assert_mem_eq(end, made.end, 6 * sizeof *end);
    ck_assert_uint_eq(report.first_contacts, 0);
    ck_assert_int_eq(report.held, 0);
    ck_assert_double_eq(report.followed, 1);
    ck_assert_double_eq(report.energy_before, 0);
}
END_TEST

// A lid from height 2 to -2, and under it a point at 1 above a floor: so half of
// the way is free.
START_TEST(scripted_vertices_go_as_far_as_they_can)
{
    make_fall(0);
    memcpy(made.end + 4, made.start + 4, 2 * sizeof *made.end);
    for (int i = 0; i < 2; i++) {
        int v = proposal_add_vertex(&made, 8 * i - 4, 2, 0);
        made.inverse_mass[v] = 0;
        made.end[2 * v + 1] = -2;
    }
    proposal_add_edge(&made, 3, 4);
    resolve((tf_response_options){0});
    ck_assert_int_eq(report.held, 2);
    ck_assert_double_le(report.followed, 0.5);
    ck_assert_double_ge(report.followed, 0.5 - 0x1p-7);
    for (int i = 6; i < 10; i++)
        ck_assert_double_eq(end[i],
                            made.start[i] + (made.end[i] - made.start[i]) *
                                                report.followed);
    ck_assert_double_eq(report.energy_before, 0);
}
END_TEST

// Less than 1/128 of the way counts for nothing.
START_TEST(scripted_vertices_may_have_no_way_to_go)
{
    make_fall(0);
    memcpy(made.end + 4, made.start + 4, 2 * sizeof *made.end);
    for (int i = 0; i < 2; i++) {
        int v = proposal_add_vertex(&made, 8 * i - 4, 2, 0);
        made.inverse_mass[v] = 0;
        made.end[2 * v + 1] = -400;
    }
    proposal_add_edge(&made, 3, 4);
    resolve((tf_response_options){0});
    ck_assert_mem_eq(end, made.start, 10 * sizeof *end);
    ck_assert_double_eq(report.followed, 0);
    ck_assert_int_eq(report.held, 2);
    ck_assert_uint_gt(report.first_contacts,
                      0); // of the step that was proposed
}
END_TEST

START_TEST(huge_coordinates_are_resolved)
{
    make_fall(1);
    for (int i = 0; i < 6; i++) {
        made.start[i] *= 0x1p1021;
        made.end[i] = i % 2 ? -made.start[i] : DBL_MAX;
    }
    resolve((tf_response_options){.friction = 1, .restitution = 1});
    for (int i = 0; i < 6; i++)
        ck_assert(isfinite(end[i]));
}
END_TEST

START_TEST(tiny_coordinates_are_resolved)
{
    make_fall(1);
    for (int i = 0; i < 6; i++) {
        made.start[i] *= 0x1p-1072;
        made.end[i] *= 0x1p-1072;
    }
    resolve((tf_response_options){.friction = 1, .restitution = 1});
    ck_assert_int_gt(report.moved, 0);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("response/resolve");
    TCase *bad = tcase_create("trouble");
    tcase_add_test(bad, options_out_of_range_are_refused);
    tcase_add_loop_test(bad, invalid_masses_are_rejected, 0, 5);
    tcase_add_loop_test(bad, invalid_friction_of_vertices_is_rejected, 0, 5);
    tcase_add_test(bad, invalid_positions_are_rejected);
    tcase_add_test(bad, starts_that_are_not_clear_are_rejected);
    tcase_add_test_raise_signal(bad, null_breaks_the_contract, SIGABRT);
    suite_add_tcase(suite, bad);

    TCase *tcase = tcase_create("answers");
    tcase_add_test(tcase, clear_steps_come_back_bit_for_bit);
    tcase_add_test(tcase, a_fall_is_stopped_where_it_began);
    tcase_add_test(tcase, restitution_reverses_the_approach);
    tcase_add_test(tcase, slow_approaches_have_no_restitution);
    tcase_add_test(tcase, friction_slows_sliding);
    tcase_add_test(tcase, vertices_have_their_own_friction);
    tcase_add_test(tcase, near_pairs_are_pushed_apart);
    tcase_add_loop_test(tcase, pairs_end_at_the_thickness_that_they_start_at, 0,
                        2);
    tcase_add_test(tcase, a_start_at_the_thickness_counts_to_the_last_bit);
    tcase_add_test(tcase, sheets_slide_at_their_thickness);
    tcase_add_loop_test(tcase, wild_proposals_keep_a_thickness, 0,
                        proposal_tries());
    tcase_add_loop_test(tcase, a_thickness_of_zero_changes_nothing, 0,
                        PROPOSAL_WAYS);
    tcase_add_test(tcase, scripted_vertices_pass_each_other);
    tcase_add_test(tcase, scripted_vertices_go_as_far_as_they_can);
    tcase_add_test(tcase, scripted_vertices_may_have_no_way_to_go);
    suite_add_tcase(suite, tcase);

    TCase *extreme = tcase_create("extremes");
    tcase_add_test(extreme, options_at_the_ends_of_their_ranges_are_taken);
    tcase_add_test(extreme, masses_of_any_size_are_taken);
    tcase_add_test(extreme, huge_coordinates_are_resolved);
    tcase_add_test(extreme, tiny_coordinates_are_resolved);
    suite_add_tcase(suite, extreme);
    return suite;
}
