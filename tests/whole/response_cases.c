// Steps that are hard to resolve each for a reason of its own, and what stays
// the same when they are resolved.
#include "response/gauss_seidel.h"
#include "support/resolutions.h"
#include "support/scrambled_workers.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/tangle.h"
#include "threads/threads.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static proposal made;

static tf_response_report expect_resolved(bool weighed,
                                          const tf_response_options *options)
{
    tf_response_report report = {0};
    const char *fault = resolution_fault(
        &made, weighed, made.mesh.vertices < 40, options, &report);
    ck_assert_msg(!fault, "%s", fault);
    return report;
}

static void move(int first, int count, double x, double y, double z)
{
    const double way[] = {x, y, z};
    int axes = made.mesh.axes;
    for (int i = axes * first; i < axes * (first + count); i++)
        made.end[i] += way[i % axes];
}

static const tf_response_options each_level[] = {
    {0},
    {.impulse_rounds = 30, .zone_rounds = -1},
    {.zone_rounds = -1},
    {.zone_rounds = -1, .rigid = true},
    {.separation = -1}};

enum {
    LEVELS = sizeof each_level / sizeof *each_level
};

/// As `expect_resolved`, for a step that meets, by each level alone.
static void expect_resolved_by_all(void)
{
    static double proposed[3 * PROPOSAL_VERTICES];
    memcpy(proposed, made.end, sizeof proposed);
    for (int i = 0; i < LEVELS; i++) {
        memcpy(made.end, proposed, sizeof proposed);
        tf_response_report report = expect_resolved(false, &each_level[i]);
        ck_assert_uint_gt(report.first_contacts, 0);
        ck_assert_int_gt(report.moved, 0);
    }
}

// Lattice pairs ---------------------------------------------------------------

typedef enum lattice_pair {
    TRIANGLE_AND_SPECK,
    TWO_RODS,
    TRIANGLE_AND_ROD,
    EDGE_AND_SPECK, // in the plane
    TWO_EDGES
} lattice_pair;

enum {
    LATTICE_PAIRS = TWO_EDGES + 1
};

static void make_lattice_pair(generator *random, lattice_pair pair)
{
    static const int triangles[] = {1, 0, 1, 0, 0}, edges[] = {0, 2, 1, 1, 2};
    static const int vertices[] = {4, 4, 5, 3, 4};
    proposal_begin(&made, pair < EDGE_AND_SPECK ? 3 : 2);
    for (int v = 0; v < vertices[pair]; v++)
        proposal_add_vertex(&made, 0, 0, 0);
    int v = below(random, 2) ? vertices[pair] - 1 : 0;
    int next = v == 0 ? 1 : -1; // in one or the other order
    if (triangles[pair]) {
        proposal_add_triangle(&made, v, v + next, v + 2 * next);
        v += 3 * next;
    }
    for (int i = 0; i < edges[pair]; i++, v += 2 * next)
        proposal_add_edge(&made, v, v + next);
    for (int i = 0; i < made.mesh.axes * made.mesh.vertices; i++) {
        made.start[i] = below(random, 5) - 2;
        made.end[i] = below(random, 5) - 2;
    }
}

static tf_status resolve(const tf_response_options *options,
                         tf_response_report *report)
{
    tf_surface *surface = surface_of(&made.mesh);
    tf_resolver *resolver = NULL;
    ck_assert_int_eq(tf_resolver_create(surface, &resolver), TF_OK);
    const tf_response_report *lent;
    tf_status status = tf_step_resolve(resolver, made.mesh.vertices, made.start,
                                       made.end, NULL, options, &lent, NULL);
    if (status == TF_OK && report)
        *report = *lent;
    tf_resolver_free(resolver);
    tf_surface_free(surface);
    return status;
}

START_TEST(lattice_pairs_are_resolved_or_rejected)
{
    static const tf_response_options options = {.check_start = true};
    generator random = generator_new(100 + (uint64_t)_i);
    int rejected = 0, met = 0, tries = (int)cases_at_least(20, 500);
    for (int i = 0; i < tries; i++) {
        tf_response_report report;
        make_lattice_pair(&random, (lattice_pair)_i);
        tangle_judge *judge = tangle_judge_new(&made.mesh);
        bool tangled = tangle_count(judge, made.start) > 0;
        tf_status status = resolve(&options, &report);
        ck_assert_int_eq(status, tangled ? TF_START_NOT_CLEAR : TF_OK);
        rejected += tangled;
        if (!tangled) {
            ck_assert_int_eq(tangle_count_all(judge, made.end), 0);
            ck_assert_int_eq(tangle_count_in_step(judge, made.start, made.end),
                             0);
            met += report.first_contacts > 0;
        }
        tangle_judge_free(judge);
    }
    printf("%d rejected, %d of %d with contacts\n", rejected, met, tries);
    ck_assert_int_gt(50 * rejected, tries);
    ck_assert_int_gt(20 * met, tries);
}
END_TEST

// By hand ---------------------------------------------------------------------

START_TEST(aligned_sheets_are_resolved)
{
    proposal_begin(&made, 3);
    proposal_add_sheet(&made, 4, 0);
    int upper = proposal_add_sheet(&made, 4, 1);
    move(upper, 25, 0, 0, -2);
    expect_resolved_by_all();
}
END_TEST

// Its displacement is no double, and some of its coordinates are -0.
START_TEST(a_step_without_contacts_ends_as_proposed)
{
    proposal_begin(&made, 3);
    proposal_add_sheet(&made, 2, 0);
    proposal_add_sheet(&made, 2, 1);
    move(9, 9, 0.1, 0.1, -2);
    int far = proposal_add_sheet(&made, 2, 9);
    move(far, 9, 1e-17, 0x1p-60, 1e5);
    made.end[3 * far] = made.end[3 * far + 4] = -0.;
    static double proposed[3 * PROPOSAL_VERTICES];
    memcpy(proposed, made.end, sizeof proposed);
    tf_response_report report = expect_resolved(false, &each_level[_i]);
    ck_assert_uint_gt(report.first_contacts, 0);
    ck_assert_mem_eq(made.end + 3 * far, proposed + 3 * far,
                     27 * sizeof *proposed);
}
END_TEST

START_TEST(parallel_edges_are_resolved)
{
    proposal_begin(&made, 3);
    for (int i = 0; i < 4; i++) {
        int first = proposal_add_vertex(&made, 0, i, 0);
        proposal_add_edge(&made, first, proposal_add_vertex(&made, 1, i, 0));
        move(first, 2, 0, i % 2 ? -2 : 1, 0);
    }
    expect_resolved_by_all();
}
END_TEST

/// Two cones, tip to tip.
START_TEST(a_vertex_on_a_vertex_is_resolved)
{
    proposal_begin(&made, 3);
    for (int side = -1; side <= 1; side += 2) {
        int tip = proposal_add_vertex(&made, 0, 0, side);
        for (int i = 0; i < 4; i++)
            proposal_add_vertex(&made, i % 2 ? 0 : 1 - i, i % 2 ? i - 2 : 0,
                                3 * side);
        for (int i = 0; i < 4; i++)
            proposal_add_triangle(&made, tip, tip + 1 + i,
                                  tip + 1 + (i + 1) % 4);
        move(tip, 5, 0, 0, -side);
    }
    expect_resolved_by_all();
    for (int i = 0; i < 3 * made.mesh.vertices; i++)
        made.end[i] = made.start[i] + (i % 3 == 2 ? i < 15 ? 4 : -4 : 0);
    expect_resolved_by_all();
}
END_TEST

START_TEST(motion_in_one_plane_is_resolved)
{
    proposal_begin(&made, 3);
    proposal_add_sheet(&made, 2, 0);
    int speck = proposal_add_vertex(&made, 3, 0.5, 0);
    int rod = proposal_add_vertex(&made, -1, 0.5, 0);
    proposal_add_edge(&made, rod, proposal_add_vertex(&made, -2, 0.25, 0));
    move(speck, 1, -2.5, 0, 0);
    move(rod, 2, 2, 0, 0);
    expect_resolved_by_all();
}
END_TEST

START_TEST(isolated_vertices_are_resolved)
{
    proposal_begin(&made, 3);
    proposal_add_sheet(&made, 2, 0);
    for (int i = 0; i < 9; i++) {
        int speck = proposal_add_vertex(&made, i % 3, i / 3, 1);
        move(speck, 1, 0, 0, -2);
    }
    expect_resolved_by_all();
}
END_TEST

START_TEST(a_triangle_that_turns_over_in_its_plane_is_resolved)
{
    for (int axes = 2; axes <= 3; axes++) {
        proposal_begin(&made, axes);
        for (int i = 0; i < 3; i++)
            proposal_add_vertex(&made, i, i == 1, 0);
        for (int i = 0; i < 3 && axes == 2; i++)
            proposal_add_edge(&made, i, (i + 1) % 3);
        if (axes == 3)
            proposal_add_triangle(&made, 0, 1, 2);
        move(1, 1, 0, -2, 0);
        tf_response_report report = expect_resolved(false, NULL);
        // In space it may: no two of its elements have no vertex in common.
        ck_assert_uint_eq(report.first_contacts > 0, axes == 2);
    }
}
END_TEST

// Scripted vertices -----------------------------------------------------------

static void fix(int first, int count)
{
    for (int v = first; v < first + count; v++)
        made.inverse_mass[v] = 0;
}

START_TEST(two_closing_scripted_plates_are_held_back)
{
    proposal_begin(&made, 3);
    int low = proposal_add_sheet(&made, 2, 0);
    int high = proposal_add_sheet(&made, 2, 2);
    proposal_add_sheet(&made, 2, 1);
    fix(low, 9);
    fix(high, 9);
    move(low, 9, 0, 0, 1.5);
    move(high, 9, 0, 0, -1.5);
    tf_response_report report = expect_resolved(true, NULL);
    ck_assert_int_gt(report.held, 0);
}
END_TEST

START_TEST(a_scripted_plate_that_pushes_is_not_held_back)
{
    proposal_begin(&made, 3);
    int plate = proposal_add_sheet(&made, 2, 0);
    proposal_add_sheet(&made, 2, 1);
    fix(plate, 9);
    move(plate, 9, 0, 0, 3);
    tf_response_report report = expect_resolved(true, NULL);
    ck_assert_int_eq(report.held, 0);
    ck_assert_int_eq(report.rounds[TF_FAILSAFE], 0);
    ck_assert_int_eq(report.moved, 9);
}
END_TEST

static void roughen(generator *random, int first, int count)
{
    for (int v = first; v < first + count; v++)
        for (int k = 0; k < 3; k++)
            made.start[3 * v + k] += uniform(random, -0.1, 0.1);
    memcpy(made.end, made.start, sizeof made.end);
}

// By the failsafe alone, which moves all as the plate does.  Of a rough plate
// no two vertices move by the same displacement, to the last bit.
START_TEST(a_scripted_plate_carries_the_vertices_that_it_meets)
{
    static const tf_response_options options = {.zone_rounds = -1};
    generator random = generator_new(700);
    double sideways = _i == 0 ? 0 : 0.7;
    proposal_begin(&made, 3);
    int plate = proposal_add_sheet(&made, 2, 0);
    int sheet = proposal_add_sheet(&made, 2, 1);
    if (_i == 1)
        roughen(&random, 0, 18);
    fix(plate, 9);
    move(plate, 9, sideways, sideways, 3 + sideways);
    move(sheet, 9, 0, 0, -1);
    tf_response_report report = expect_resolved(true, &options);
    ck_assert_int_eq(report.held, 0);
    ck_assert_int_eq(report.resting, 0);
    for (int v = sheet; v < sheet + 9; v++)
        ck_assert_double_eq_tol(made.end[3 * v + 2] - made.start[3 * v + 2],
                                3 + sideways, 1e-14);
}
END_TEST

// Translations ----------------------------------------------------------------

static void make_close_sheets(double gap)
{
    proposal_begin(&made, 3);
    for (int i = 0; i < 3; i++)
        proposal_add_sheet(&made, 3, i * gap);
}

START_TEST(a_huge_translation_on_a_lattice_meets_nothing)
{
    for (int exponent = 0; exponent < 50; exponent++) {
        make_close_sheets(1);
        move(0, made.mesh.vertices, ldexp(1, exponent), -ldexp(3, exponent),
             ldexp(1, exponent));
        tf_response_report report = expect_resolved(false, NULL);
        ck_assert_uint_eq(report.first_contacts, 0);
        ck_assert_int_eq(report.moved, 0);
    }
}
END_TEST

// The gap is lost in rounding, and no zone is there to make it wider.  The
// first round of the failsafe only unites what moves alike; the second finds
// contacts within a group and puts it to rest.  What is scripted may go a part of
// the way.
START_TEST(a_huge_translation_off_a_lattice_is_refused)
{
    static const tf_response_options options = {.zone_rounds = -1};
    make_close_sheets(1e-10);
    move(0, made.mesh.vertices, 0, 0, 0x1p40);
    tf_response_report report = expect_resolved(true, &options);
    ck_assert_uint_gt(report.first_contacts, 0);
    ck_assert_int_ge(report.rounds[TF_FAILSAFE], 2);
    ck_assert_int_gt(report.resting, 0);
    make_close_sheets(1e-10);
    fix(0, 5);
    move(0, made.mesh.vertices, 0, 0, 0x1p40);
    report = expect_resolved(true, &options);
    ck_assert_int_eq(report.held, 5);
    ck_assert_double_lt(report.followed, 1);
}
END_TEST

// What is kept ----------------------------------------------------------------

static double mass(int vertex)
{
    return made.inverse_mass[vertex] > 0 ? 1 / made.inverse_mass[vertex] : 0;
}

/// The kinetic energy, and what rounding of the ends may change of it.
static double energy(double *slack)
{
    int axes = made.mesh.axes;
    double sum = 0;
    *slack = 0;
    for (int i = 0; i < axes * made.mesh.vertices; i++) {
        double d = made.end[i] - made.start[i], x = fabs(made.end[i]);
        sum += 0.5 * mass(i / axes) * d * d;
        *slack += 0x1p-48 * mass(i / axes) * (fabs(d) + x) * fabs(d);
    }
    return sum;
}

/// Of the vertices that were proposed to move; scripted ones rest.
static void make_random(generator *random, int number, bool scripted)
{
    static const proposal_way ways[] = {SCATTERED, SPIKED, INSIDE_OUT,
                                        FLATTENED, SHUFFLED};
    tangle_judge *judge = NULL;
    do {
        if (judge)
            tangle_judge_free(judge);
        proposal_make(random, (proposal_shape)(number % PROPOSAL_SHAPES),
                      1 + number % 3, ways[number % 5], &made);
        judge = tangle_judge_new(&made.mesh);
    } while (tangle_count(judge, made.start) > 0);
    tangle_judge_free(judge);
    proposal_weigh(random, &made);
    int axes = made.mesh.axes;
    for (int v = 0; v < made.mesh.vertices; v++)
        if (made.inverse_mass[v] == 0 && scripted)
            memcpy(made.end + axes * v, made.start + axes * v,
                   sizeof(double) * (size_t)axes);
        else if (made.inverse_mass[v] == 0)
            made.inverse_mass[v] = 1;
}

START_TEST(without_separation_resting_obstacles_add_no_energy)
{
    static const tf_response_options levels[] = {
        {.separation = -1},
        {.separation = -1, .sweeps = 3},
        {.separation = -1, .impulse_rounds = 5, .zone_rounds = -1},
        {.separation = -1, .zone_rounds = -1}};
    generator random = generator_new(200 + (uint64_t)_i);
    for (int i = 0; i < (int)cases(30); i++) {
        double slack, more_slack;
        make_random(&random, i, true);
        double before = energy(&slack);
        tf_response_report report = expect_resolved(true, &levels[_i]);
        double after = energy(&more_slack);
        slack = fmax(slack, more_slack);
        ck_assert_msg(after <= before + slack, "%d: energy %g, was %g", i,
                      after, before);
        ck_assert_double_le(fabs(report.energy_before - before),
                            slack + 1e-9 * before);
        ck_assert_double_le(fabs(report.energy_after - after),
                            slack + 1e-9 * before);
    }
}
END_TEST

static double momentum(const double ends[], int axis, double *slack)
{
    int axes = made.mesh.axes;
    double sum = 0;
    for (int v = 0; v < made.mesh.vertices; v++) {
        double end = ends[axes * v + axis];
        double d = end - made.start[axes * v + axis];
        sum += mass(v) * d;
        *slack += 0x1p-45 * mass(v) * (fabs(d) + fabs(end));
    }
    return sum;
}

// The momentum is that of the motion.  Pushes have none, and a group of the
// failsafe drops those of its vertices.
START_TEST(free_bodies_keep_their_momentum)
{
    static const tf_response_options levels[] = {
        {0},
        {.impulse_rounds = 5, .zone_rounds = -1, .friction = 0.5},
        {.zone_rounds = -1},
        {.restitution = 1, .friction = 0.3}};
    generator random = generator_new(300 + (uint64_t)_i);
    int kept = 0, tries = (int)cases(30);
    for (int i = 0; i < tries; i++) {
        double before[3], slack = 0;
        make_random(&random, i, false);
        for (int k = 0; k < made.mesh.axes; k++)
            before[k] = momentum(made.end, k, &slack);
        tf_response_report report = expect_resolved(true, &levels[_i]);
        if (report.resting > 0)
            continue;
        kept++;
        for (int k = 0; k < made.mesh.axes; k++)
            ck_assert_double_eq_tol(momentum(resolution_motion(), k, &slack),
                                    before[k], slack);
    }
    ck_assert_int_gt(2 * kept, tries);
}
END_TEST

// Extreme units ---------------------------------------------------------------

/// Scales all coordinates by a power of two.
static void change_unit(int exponent)
{
    for (int i = 0; i < made.mesh.axes * made.mesh.vertices; i++) {
        made.start[i] = ldexp(made.start[i], exponent);
        made.end[i] = ldexp(made.end[i], exponent);
    }
}

static int largest_exponent(void)
{
    int largest = INT_MIN;
    for (int i = 0; i < made.mesh.axes * made.mesh.vertices; i++) {
        double x = fmax(fabs(made.start[i]), fabs(made.end[i]));
        if (x > 0 && ilogb(x) > largest)
            largest = ilogb(x);
    }
    return largest;
}

static bool starts_tangled(void)
{
    tangle_judge *judge = tangle_judge_new(&made.mesh);
    bool tangled = tangle_count(judge, made.start) > 0;
    tangle_judge_free(judge);
    return tangled;
}

START_TEST(the_largest_and_the_least_doubles_are_resolved)
{
    static const int exponents[] = {1023, 1010, -500, -1000, -1050};
    static const tf_response_options levels[] = {{0}, {.zone_rounds = -1}};
    generator random = generator_new(600 + (uint64_t)_i);
    for (int i = 0; i < (int)cases(15); i++) {
        make_random(&random, i, i % 2);
        change_unit(exponents[_i] - largest_exponent());
        if (!starts_tangled()) // by rounding
            expect_resolved(true, &levels[i % 4 / 2]);
    }
}
END_TEST

// Solvers of other people -----------------------------------------------------

static size_t no_workspace(int axes, int vertices, int constraints)
{
    (void)axes;
    (void)vertices;
    (void)constraints;
    return 0;
}

static int do_nothing(tf_zone *zone)
{
    (void)zone;
    return 0;
}

static int push_about(tf_zone *zone)
{
    generator random = generator_new((uint64_t)zone->constraints);
    double *impulse = malloc(sizeof *impulse * (size_t)zone->constraints);
    ck_assert_ptr_nonnull(impulse);
    for (int i = 0; i < zone->constraints; i++)
        impulse[i] = zone->constraint[i].impulse = uniform(&random, -1, 1);
    tf_zone_push(zone, impulse, zone->displacement);
    free(impulse);
    return 1;
}

static size_t usual_workspace(int axes, int vertices, int constraints)
{
    return tf_gauss_seidel.workspace(axes, vertices, 2 * constraints);
}

/// A copy of the zone with each constraint so many times, none of them solved
/// yet.
static tf_zone repeat_constraints(const tf_zone *zone, int times)
{
    tf_zone repeated = *zone;
    repeated.solved = 0;
    repeated.constraints = times * zone->constraints;
    repeated.constraint =
        malloc(sizeof *zone->constraint * (size_t)repeated.constraints);
    ck_assert_ptr_nonnull(repeated.constraint);
    for (int i = 0; i < repeated.constraints; i++) {
        repeated.constraint[i] = zone->constraint[i / times];
        repeated.constraint[i].impulse /= times;
    }
    return repeated;
}

/// The constraints in another order.
static int sweep_shuffled(tf_zone *zone)
{
    generator random = generator_new((uint64_t)zone->constraints);
    tf_zone shuffled = repeat_constraints(zone, 1);
    int *from = malloc(sizeof *from * (size_t)zone->constraints);
    ck_assert_ptr_nonnull(from);
    for (int i = 0; i < zone->constraints; i++) {
        int j = below(&random, i + 1);
        from[i] = from[j];
        from[j] = i;
    }
    for (int i = 0; i < zone->constraints; i++)
        shuffled.constraint[i] = zone->constraint[from[i]];
    int sweeps = tf_gauss_seidel.solve(&shuffled);
    for (int i = 0; i < zone->constraints; i++)
        zone->constraint[from[i]] = shuffled.constraint[i];
    free(shuffled.constraint);
    free(from);
    return sweeps;
}

static void expect_constraint(const tf_zone *zone,
                              const tf_constraint *constraint)
{
    double square = 0, mass_moved = 0;
    for (int k = 0; k < 3; k++)
        square += constraint->normal[k] * constraint->normal[k];
    for (int i = 0; i < 4 && constraint->vertex[i] >= 0; i++)
        mass_moved += zone->inverse_mass[constraint->vertex[i]];
    ck_assert_double_le(fabs(square - 1), 1e-12);
    ck_assert_double_gt(mass_moved, 0);
    ck_assert_double_ge(constraint->bound, 0);
    ck_assert(isfinite(constraint->bound));
}

static int expect_pushes(tf_zone *zone)
{
    for (int i = 0; i < zone->constraints; i++)
        expect_constraint(zone, &zone->constraint[i]);
    int sweeps = tf_gauss_seidel.solve(zone);
    for (int i = 0; i < zone->constraints; i++)
        ck_assert_double_ge(zone->constraint[i].impulse, 0);
    return sweeps;
}

START_TEST(the_step_is_clear_whatever_the_solver_does)
{
    static const tf_zone_solver solvers[] = {
        {"idle", no_workspace, do_nothing},
        {"random", no_workspace, push_about},
        {"shuffled", usual_workspace, sweep_shuffled},
        {"checked", usual_workspace, expect_pushes}};
    generator random = generator_new(400 + (uint64_t)_i);
    tf_response_options options = {.solver = &solvers[_i]};
    for (int i = 0; i < (int)cases(15); i++) {
        make_random(&random, i, i % 2);
        expect_resolved(true, &options);
    }
}
END_TEST

// Each call makes at least one sweep, from the impulses of the last.
static void converge(tf_zone *zone)
{
    size_t size = sizeof(double) * (size_t)(zone->axes * zone->vertices);
    double *proposed = malloc(size);
    ck_assert_ptr_nonnull(proposed);
    memcpy(proposed, zone->displacement, size);
    for (int i = 0; i < 1000; i++) {
        memcpy(zone->displacement, proposed, size);
        tf_gauss_seidel.solve(zone);
    }
    free(proposed);
}

/// Without friction.
static int solve_repeated(tf_zone *zone, int times)
{
    tf_zone repeated = repeat_constraints(zone, times);
    converge(&repeated);
    for (int i = 0; i < zone->constraints; i++)
        zone->constraint[i].impulse = 0;
    for (int i = 0; i < repeated.constraints; i++)
        zone->constraint[i / times].impulse += repeated.constraint[i].impulse;
    free(repeated.constraint);
    return 1;
}

static int solve_once(tf_zone *zone)
{
    return solve_repeated(zone, 1);
}

static int solve_doubled(tf_zone *zone)
{
    return solve_repeated(zone, 2);
}

START_TEST(every_constraint_twice_ends_the_same)
{
    static const tf_zone_solver once = {"once", usual_workspace, solve_once};
    static const tf_zone_solver doubled = {"doubled", usual_workspace,
                                           solve_doubled};
    static double end[3 * PROPOSAL_VERTICES];
    proposal_begin(&made, 3);
    for (int i = 0; i < 3; i++)
        proposal_add_sheet(&made, 3, 0.5 * i);
    for (int v = 0; v < 16; v++) {
        double ripple = 0.3 * sin(3.0 * v);
        move(v, 1, 0.1 * ripple, 0.1, 0.7 + ripple);
        move(32 + v, 1, 0.1, ripple, -0.7);
    }
    static proposal copy;
    copy = made;
    tf_response_report report =
        expect_resolved(false, &(tf_response_options){.solver = &once});
    ck_assert_int_gt(report.rounds[TF_ZONES], 0);
    ck_assert_int_eq(report.rounds[TF_FAILSAFE], 0);
    memcpy(end, made.end, sizeof end);
    made = copy;
    expect_resolved(false, &(tf_response_options){.solver = &doubled});
    for (int i = 0; i < 3 * made.mesh.vertices; i++)
        ck_assert_double_eq_tol(made.end[i], end[i], 1e-6);
}
END_TEST

// Friction --------------------------------------------------------------------

START_TEST(equal_friction_of_vertices_is_that_of_all)
{
    static const tf_response_options levels[] = {
        {.size = sizeof *levels},
        {.size = sizeof *levels, .impulse_rounds = 5, .zone_rounds = -1}};
    static double own[PROPOSAL_VERTICES];
    generator random = generator_new(600);
    int met = 0, count = (int)cases_at_least(20, 100);
    for (int i = 0; i < count; i++) {
        static proposal copy;
        make_random(&random, i, i % 2);
        double friction = i % 8 ? uniform(&random, 0, 1.5) : 0;
        for (int v = 0; v < made.mesh.vertices; v++)
            own[v] = friction;
        copy = made;
        tf_response_options options = levels[i % 2];
        options.friction = friction;
        expect_resolved(true, &options);
        proposal resolved = made;
        made = copy;
        options.friction = 0;
        options.vertex_friction = own;
        met += expect_resolved(true, &options).first_contacts > 0;
        ck_assert_mem_eq(made.end, resolved.end, sizeof made.end);
    }
    ck_assert_int_gt(10 * met, count);
}
END_TEST

// Threads ---------------------------------------------------------------------

static void expect_same_bits(const tf_parallel *parallel)
{
    static proposal copy;
    tf_response_options options = {.rigid = true, .friction = 0.1};
    copy = made;
    tf_response_report alone = expect_resolved(true, &options);
    options.parallel = parallel;
    proposal resolved = made;
    made = copy;
    tf_response_report shared = expect_resolved(true, &options);
    ck_assert_mem_eq(made.end, resolved.end, sizeof made.end);
    ck_assert_mem_eq(alone.rounds, shared.rounds, sizeof alone.rounds);
    ck_assert_uint_eq(alone.contacts, shared.contacts);
    ck_assert(alone.violation == shared.violation);
    ck_assert(alone.energy_after == shared.energy_after);
}

START_TEST(any_number_of_threads_ends_with_the_same_bits)
{
    generator random = generator_new(500);
    for (int i = 0; i < (int)cases(15); i++) {
        int workers = 1 + i % 3;
        tf_threads *threads;
        ck_assert_int_eq(tf_threads_create(workers, &threads), TF_OK);
        tf_parallel backward = scrambled_workers(&workers);
        make_random(&random, i, i % 2);
        expect_same_bits(i % 4 < 2 ? tf_threads_parallel(threads) : &backward);
        tf_threads_free(threads);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/response_cases");
    TCase *lattice = tcase_create("lattice");
    tcase_add_loop_test(lattice, lattice_pairs_are_resolved_or_rejected, 0,
                        LATTICE_PAIRS);
    suite_add_tcase(suite, lattice);

    TCase *hand = tcase_create("by hand");
    tcase_add_test(hand, aligned_sheets_are_resolved);
    tcase_add_loop_test(hand, a_step_without_contacts_ends_as_proposed, 0,
                        LEVELS);
    tcase_add_test(hand, parallel_edges_are_resolved);
    tcase_add_test(hand, a_vertex_on_a_vertex_is_resolved);
    tcase_add_test(hand, motion_in_one_plane_is_resolved);
    tcase_add_test(hand, isolated_vertices_are_resolved);
    tcase_add_test(hand, a_triangle_that_turns_over_in_its_plane_is_resolved);
    tcase_add_test(hand, two_closing_scripted_plates_are_held_back);
    tcase_add_test(hand, a_scripted_plate_that_pushes_is_not_held_back);
    tcase_add_loop_test(
        hand, a_scripted_plate_carries_the_vertices_that_it_meets, 0, 2);
    tcase_add_test(hand, a_huge_translation_on_a_lattice_meets_nothing);
    tcase_add_test(hand, a_huge_translation_off_a_lattice_is_refused);
    suite_add_tcase(suite, hand);

    TCase *kept = tcase_create("kept");
    tcase_add_loop_test(
        kept, without_separation_resting_obstacles_add_no_energy, 0, 4);
    tcase_add_loop_test(kept, free_bodies_keep_their_momentum, 0, 4);
    suite_add_tcase(suite, kept);

    TCase *units = tcase_create("units");
    tcase_add_loop_test(units, the_largest_and_the_least_doubles_are_resolved,
                        0, 5);
    suite_add_tcase(suite, units);

    TCase *solvers = tcase_create("solvers");
    tcase_add_loop_test(solvers, the_step_is_clear_whatever_the_solver_does, 0,
                        4);
    tcase_add_test(solvers, every_constraint_twice_ends_the_same);
    tcase_add_test(solvers, equal_friction_of_vertices_is_that_of_all);
    suite_add_tcase(suite, solvers);

    TCase *threads = tcase_create("threads");
    tcase_add_test(threads, any_number_of_threads_ends_with_the_same_bits);
    suite_add_tcase(suite, threads);
    return suite;
}
