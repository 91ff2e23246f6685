// Projected Gauss-Seidel on random zones.
#include "response/gauss_seidel.h"

#include "response/impulse.h"
#include "support/long_solves.h"
#include "support/memory.h"
#include "support/support.h"
#include "support/watches.h"
#include "support/zones.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    VERTICES = 12,
    MOST_CONSTRAINTS = 40,
    MANY = 2000,
    CROWDED = 600
};

static zone_case random_zone(generator *random, int axes)
{
    int constraints = 1 + below(random, MOST_CONSTRAINTS / 2);
    zone_case z =
        zone_random(random, axes, VERTICES, constraints, MOST_CONSTRAINTS);
    for (int i = below(random, constraints + 1); i > 0; i--)
        zone_duplicate(&z, below(random, constraints), 1);
    return z;
}

/// Solves it until next to nothing changes.
static void converge(zone_case *z)
{
    zone_solve(z, &tf_gauss_seidel, MANY);
    for (int i = 0; i < 20; i++)
        zone_solve_again(z, &tf_gauss_seidel, MANY);
}

static double energy(const zone_case *z)
{
    double sum = 0;
    for (int i = 0; i < VERTICES; i++)
        for (int k = 0; k < z->zone.axes; k++) {
            double d = z->displacement[z->zone.axes * i + k];
            if (z->inverse_mass[i] > 0)
                sum += d * d / z->inverse_mass[i] / 2;
        }
    return sum;
}

// Bounds ----------------------------------------------------------------------

// Where a constraint pushes, it is satisfied as an equation: complementarity.
START_TEST(constraints_are_satisfied_and_do_not_pull)
{
    generator random = generator_new(100 + (uint64_t)_i);
    for (int times = 0; times < (int)cases(200); times++) {
        zone_case z =
            zone_random(&random, 2 + _i, VERTICES, 6, MOST_CONSTRAINTS);
        converge(&z);
        double gap_change[MOST_CONSTRAINTS];
        tf_zone_gap_changes(&z.zone, z.displacement, gap_change);
        for (int i = 0; i < z.zone.constraints; i++) {
            const tf_constraint *constraint = &z.constraint[i];
            ck_assert_double_ge(constraint->impulse, 0);
            ck_assert_double_ge(gap_change[i], constraint->bound - 1e-4);
            if (constraint->impulse > 1e-2)
                ck_assert_double_le(gap_change[i], constraint->bound + 1e-3);
        }
        zone_free(&z);
    }
}
END_TEST

START_TEST(constraints_listed_twice_change_nothing)
{
    generator random = generator_new(200);
    for (int times = 0; times < (int)cases(100); times++) {
        zone_case z = zone_random(&random, 3, VERTICES, 8, MOST_CONSTRAINTS);
        double once[3 * VERTICES];
        converge(&z);
        memcpy(once, z.displacement, sizeof once);
        for (int i = 0; i < 8; i++)
            zone_duplicate(&z, i, 1);
        converge(&z);
        ck_assert_double_lt(zone_distance(&z, once, z.displacement), 1e-3);
        zone_free(&z);
    }
}
END_TEST

// Energy ----------------------------------------------------------------------

// The energy is the proposal's plus what the sweeps minimize, which is 0 at
// first, for any number of sweeps and any rank.
START_TEST(no_sweep_raises_the_energy)
{
    generator random = generator_new(300 + (uint64_t)_i);
    for (int times = 0; times < (int)cases(200); times++) {
        zone_case z = random_zone(&random, 2 + _i);
        for (int i = 0; i < z.zone.constraints; i++)
            z.constraint[i].bound = 0;
        for (int i = 0; i < VERTICES; i++)
            for (int k = 0; k < z.zone.axes && z.inverse_mass[i] == 0; k++)
                z.proposal[z.zone.axes * i + k] = 0;
        zone_solve(&z, &tf_gauss_seidel, 1);
        memcpy(z.displacement, z.proposal,
               sizeof(double) * (size_t)z.zone.axes * VERTICES);
        double proposed = energy(&z);
        for (int sweep = 0; sweep < 20; sweep++) {
            zone_solve_again(&z, &tf_gauss_seidel, 1);
            ck_assert_double_le(energy(&z), proposed * (1 + 1e-12));
        }
        zone_free(&z);
    }
}
END_TEST

// Work ------------------------------------------------------------------------

START_TEST(no_more_sweeps_than_allowed)
{
    generator random = generator_new(400);
    for (int sweeps = 1; sweeps < 30; sweeps++) {
        zone_case z = random_zone(&random, 3);
        ck_assert_int_le(zone_solve(&z, &tf_gauss_seidel, sweeps), sweeps);
        zone_free(&z);
    }
}
END_TEST

/// A zone in the plane, of which only the last constraint is new.
static tf_zone zone_of(int vertices, int constraints,
                       tf_constraint constraint[], const double inverse_mass[],
                       double displacement[])
{
    return (tf_zone){.axes = 2,
                     .vertices = vertices,
                     .constraints = constraints,
                     .solved = constraints - 1,
                     .constraint = constraint,
                     .inverse_mass = inverse_mass,
                     .displacement = displacement,
                     .sweeps = 100};
}

static void solve(tf_zone *zone)
{
    size_t workspace = tf_gauss_seidel.workspace(zone->axes, zone->vertices,
                                                 zone->constraints);
    zone->workspace = malloc(workspace * sizeof(double));
    ck_assert_ptr_nonnull(zone->workspace);
    tf_gauss_seidel.solve(zone);
    free(zone->workspace);
}

/// A constraint that keeps a vertex from moving down, or as fast as another.
static tf_constraint constraint_of(int vertex, int other)
{
    tf_constraint constraint = {.vertex = {vertex, other, -1, -1},
                                .coefficient = {1, other >= 0 ? -1 : 0},
                                .normal = {0, 1, 0}};
    return constraint;
}

// Constraint 0 holds vertex 0, and vertex 1 falls upon it; constraint 2 is far
// away.
START_TEST(solved_constraints_wait_until_their_vertices_move)
{
    tf_constraint constraint[] = {constraint_of(2, -1), constraint_of(0, -1),
                                  constraint_of(1, 0)};
    double inverse_mass[] = {1, 1, 1}, d[] = {0, -1, 0, -2, 0, -3};
    constraint[0].impulse = 2; // wrong, but nobody has to look
    tf_zone zone = zone_of(3, 3, constraint, inverse_mass, d);
    zone.solved = 1;
    solve(&zone);
    ck_assert_double_eq(constraint[0].impulse, 2);
    ck_assert_double_eq(d[5], -1);
    ck_assert_double_ge(d[1], -0.05);
    ck_assert_double_ge(d[3], d[1] - 0.05);

    double again[] = {0, -1, 0, -2, 0, -3};
    constraint[0] = constraint_of(1, -1);
    zone.displacement = again;
    solve(&zone);
    ck_assert_msg(again[3] > -0.05,
                  "vertex 1 was moved, and constraint 0 not visited");
}
END_TEST

/// Swaps what two places of a constraint have.
static void swap_places(tf_constraint *constraint, int a, int b)
{
    int vertex = constraint->vertex[a];
    double coefficient = constraint->coefficient[a];
    constraint->vertex[a] = constraint->vertex[b];
    constraint->coefficient[a] = constraint->coefficient[b];
    constraint->vertex[b] = vertex;
    constraint->coefficient[b] = coefficient;
}

// Constraint 1 is new and pushes vertex 6 down, which constraint 0 has above
// others.
START_TEST(a_constraint_is_told_of_each_of_its_vertices)
{
    tf_constraint constraint[] = {{.vertex = {0, 1, 2, 6},
                                   .coefficient = {-0.5, -0.5, 0.5, 0.5},
                                   .normal = {0, 0, 1}},
                                  {.vertex = {3, 4, 5, 6},
                                   .coefficient = {0.5, 0.5, -0.5, -0.5},
                                   .normal = {0, 0, 1}}};
    swap_places(&constraint[0], 3, _i / 4);
    swap_places(&constraint[1], 3, _i % 4);
    double inverse_mass[] = {1, 1, 1, 1, 1, 1, 1}, d[21] = {0};
    d[3 * 3 + 2] = d[3 * 4 + 2] = -1;
    tf_zone zone = zone_of(7, 2, constraint, inverse_mass, d);
    zone.axes = 3;
    solve(&zone);
    ck_assert_double_gt(constraint[0].impulse, 0.1);
}
END_TEST

// Constraint 0 has stopped a fall of 1; constraint 1 pushes the vertex on by
// `more`.
static double impulse_left(double more)
{
    tf_constraint constraint[] = {constraint_of(0, -1), constraint_of(0, -1)};
    double inverse_mass = 1, d[] = {0, -1};
    constraint[0].impulse = 1;
    constraint[1].bound = more;
    tf_zone zone = zone_of(1, 2, constraint, &inverse_mass, d);
    solve(&zone);
    ck_assert_double_ge(d[1], more - 0.01);
    return constraint[0].impulse;
}

START_TEST(impulses_are_taken_back_if_they_push_much_too_much)
{
    ck_assert_double_eq(impulse_left(0.029), 1);
    ck_assert_double_lt(impulse_left(0.031), 1);
}
END_TEST

// Friction --------------------------------------------------------------------

/// Slides a vertex over a floor that it is pressed into by `pressed`.
static double slide(double friction, double pressed)
{
    tf_constraint constraint = constraint_of(0, -1);
    double inverse_mass = 0.5, d[] = {1, -pressed};
    tf_zone zone = zone_of(1, 1, &constraint, &inverse_mass, d);
    zone.friction = friction;
    solve(&zone);
    ck_assert_double_eq_tol(d[1], 0, 1e-12);
    ck_assert_double_eq_tol(constraint.impulse, 2 * pressed, 1e-12);
    return d[0];
}

START_TEST(friction_is_coulombs)
{
    ck_assert_double_eq_tol(slide(0, 0.5), 1, 1e-12);
    ck_assert_double_eq_tol(slide(0.5, 0.5), 0.75, 1e-12);
    ck_assert_double_eq_tol(slide(1.9, 0.5), 0.05, 1e-12);
    ck_assert_double_eq_tol(slide(2.1, 0.5), 0, 1e-12);
    ck_assert_double_eq_tol(slide(9, 0.5), 0, 1e-12);
}
END_TEST

// Two vertices slide over a third one, which is heavy.
START_TEST(vertices_have_their_own_friction)
{
    tf_constraint constraint[] = {constraint_of(0, 2), constraint_of(1, 2)};
    double numbers[] = {1, 1, 0, 0.5, 0, 0.5}, d[] = {2, -1, 2, -1, 0, 0};
    tf_zone zone = zone_of(3, 2, constraint, numbers, d);
    zone.solved = 0;
    zone.friction = -1;
    solve(&zone);
    ck_assert_double_eq_tol(d[0], 1.5, 1e-12);
    ck_assert_double_eq_tol(d[2], 2, 1e-12);
}
END_TEST

/// Gives each vertex of a zone the same coefficient.
static void give_friction(zone_case *z, double friction, double numbers[])
{
    for (int v = 0; v < z->zone.vertices; v++) {
        numbers[v] = z->inverse_mass[v];
        numbers[z->zone.vertices + v] = friction;
    }
    z->zone.inverse_mass = numbers;
    z->zone.friction = -1;
}

START_TEST(equal_friction_of_vertices_is_that_of_the_zone)
{
    generator random = generator_new(310);
    for (int i = 0; i < 20; i++) {
        zone_case z = random_zone(&random, 3);
        size_t vertices = (size_t)z.zone.vertices;
        double *numbers = allocate(2 * vertices, sizeof *numbers);
        double *once = allocate(3 * vertices, sizeof *once);
        double friction = i == 0 ? 0 : uniform(&random, 0, 2);
        z.zone.friction = friction;
        zone_solve(&z, &tf_gauss_seidel, 10);
        memcpy(once, z.displacement, 3 * vertices * sizeof *once);
        for (int c = 0; c < z.zone.constraints; c++)
            memset(z.constraint[c].friction, 0, sizeof z.constraint->friction);
        give_friction(&z, friction, numbers);
        zone_solve(&z, &tf_gauss_seidel, 10);
        ck_assert_mem_eq(z.displacement, once, 3 * vertices * sizeof *once);
        free(numbers);
        free(once);
        zone_free(&z);
    }
}
END_TEST

START_TEST(a_caller_may_cancel)
{
    const char *fault = long_solve_fault(&tf_gauss_seidel, 6);
    ck_assert_msg(!fault, "%s", fault);
}
END_TEST

/// Hubs with so many spokes each, in the plane.
static zone_case hubs_of(int hubs, int spokes)
{
    zone_case z = zone_new(2, hubs * (spokes + 1), hubs * spokes);
    z.zone.constraints = hubs * spokes;
    for (int i = 0; i < hubs * spokes; i++) {
        int hub = i / spokes, spoke = hubs + i;
        z.constraint[i] = constraint_of(hub, spoke);
        z.proposal[2 * spoke + 1] = 1;
        z.inverse_mass[spoke] = 1;
        z.inverse_mass[hub] = 0x1p-20;
    }
    return z;
}

// Numbers that are not there yet would lead anywhere.
START_TEST(an_unfinished_agenda_is_not_followed)
{
    watched_call call;
    zone_case z = hubs_of(1250, 4);
    z.zone.sweeps = 1;
    size_t bytes = sizeof(double) * tf_gauss_seidel.workspace(
                                        2, z.zone.vertices, z.zone.constraints);
    z.zone.workspace = allocate(bytes, 1);
    size_t numbers = 2 * (size_t)z.zone.vertices;
    long calls = 1;
    for (long last = 0; last <= calls; last++) {
        memset(z.zone.workspace, 0x7f, bytes);
        memcpy(z.displacement, z.proposal, numbers * sizeof *z.proposal);
        for (int i = 0; i < z.zone.constraints; i++)
            z.constraint[i].impulse = 0;
        z.zone.watch = watched_begin(&call, last);
        tf_gauss_seidel.solve(&z.zone);
        calls = last == 0 ? call.calls : calls;
        ck_assert_int_eq(call.calls, last == 0 ? calls : last);
    }
    ck_assert_int_gt(calls, 4);
    free(z.zone.workspace);
    z.zone.workspace = NULL;
    zone_free(&z);
}
END_TEST

/// The units of work for hubs with so many spokes each.
static size_t work_for_hubs(int hubs, int spokes)
{
    watched_call call;
    zone_case z = hubs_of(hubs, spokes);
    z.zone.watch = watched_begin(&call, 0);
    ck_assert_int_eq(zone_solve(&z, &tf_gauss_seidel, 1), 1);
    size_t work = watched_work(&call);
    zone_free(&z);
    return work;
}

// Six units a constraint, of which two are its visit.  A hub tells all of its
// neighbors in each, unless they are a crowd, which asks.
START_TEST(work_for_neighbors_counts)
{
    size_t alone = work_for_hubs(2048, 1), busy = work_for_hubs(32, 64);
    size_t crowded = work_for_hubs(1, 2048);
    ck_assert_uint_eq(alone, 6 * 2048);
    ck_assert_uint_eq(work_for_hubs(31, 1), 6 * 31);
    ck_assert_uint_ge(busy, alone + 2 * 2 * 2048);
    ck_assert_uint_le(crowded, alone);
}
END_TEST

// Crowds ----------------------------------------------------------------------

static bool share_a_vertex(const tf_constraint *a, const tf_constraint *b)
{
    for (int i = 0; i < 4 && a->vertex[i] >= 0; i++)
        for (int j = 0; j < 4 && b->vertex[j] >= 0; j++)
            if (a->vertex[i] == b->vertex[j])
                return true;
    return false;
}

static double missing(const zone_case *z, int i)
{
    return z->constraint[i].bound - tf_constraint_gap_change(z->zone.axes,
                                                             &z->constraint[i],
                                                             z->displacement);
}

/// Applies all impulses; returns the tolerance.
static double begin_plainly(zone_case *z, const tf_bodies *bodies)
{
    const tf_zone *zone = &z->zone;
    double most = 0;
    for (int i = 0; i < zone->solved; i++)
        most = fmax(most, missing(z, i));
    for (int i = 0; i < zone->constraints; i++)
        tf_constraint_push(
            &z->constraint[i],
            tf_vector_sum(tf_vector_at(z->constraint[i].friction, 0),
                          z->constraint[i].impulse,
                          tf_vector_at(z->constraint[i].normal, 0)),
            bodies);
    for (int i = zone->solved; i < zone->constraints; i++)
        most = fmax(most, missing(z, i));
    return 0.01 * most;
}

/// The same as the solver, with a flag for each constraint, by which each change
/// tells all others that share a vertex, found among all.  Returns the sweeps.
static int solve_plainly(zone_case *z, int sweeps)
{
    const tf_zone *zone = &z->zone;
    tf_bodies bodies = {zone->axes, z->inverse_mass, z->displacement};
    double least = begin_plainly(z, &bodies);
    bool due[CROWDED], any = true;
    int done = 0;
    for (int i = 0; i < zone->constraints; i++)
        due[i] = i >= zone->solved;
    for (; any && done < sweeps; done++) {
        any = false;
        for (int i = 0; i < zone->constraints; i++) {
            bool off =
                missing(z, i) > least || zone->friction > 0 ||
                (z->constraint[i].impulse > 0 && missing(z, i) < -3 * least) ||
                (done == 0 && i >= zone->solved);
            bool changed = due[i] && off &&
                           tf_constraint_visit(&z->constraint[i],
                                               zone->friction, &bodies) > least;
            for (int j = 0; changed && j < zone->constraints; j++)
                due[j] |= share_a_vertex(&z->constraint[i], &z->constraint[j]);
            due[i] = false;
            any |= changed;
        }
    }
    return done;
}

/// A zone in which a few vertices have many constraints, and many have few.
static zone_case crowded_zone(generator *random, int axes, int constraints)
{
    zone_case z = zone_random(random, axes, 300, constraints, CROWDED);
    int hubs = 1 + below(random, 8);
    for (int i = 0; i < constraints; i++)
        if (below(random, 3) > 0)
            z.constraint[i].vertex[0] = 2 * below(random, hubs);
    for (int i = 0; i < constraints; i++)
        for (int j = 1; j <= axes; j++)
            while (z.constraint[i].vertex[j] == z.constraint[i].vertex[0])
                z.constraint[i].vertex[j] = below(random, 300);
    z.zone.friction = below(random, 3) == 0 ? 0.3 : 0;
    return z;
}

static void copy_zone(zone_case *to, const zone_case *from)
{
    size_t bytes =
        sizeof(double) * (size_t)(from->zone.axes * from->zone.vertices);
    memcpy(to->constraint, from->constraint,
           sizeof(tf_constraint) * (size_t)from->zone.constraints);
    memcpy(to->displacement, from->proposal, bytes);
    memcpy(to->proposal, from->proposal, bytes);
    memcpy(to->inverse_mass, from->inverse_mass,
           sizeof(double) * (size_t)from->zone.vertices);
    to->zone.constraints = from->zone.constraints;
    to->zone.solved = from->zone.solved;
    to->zone.friction = from->zone.friction;
}

// At first with all constraints new, then with some solved before.  Numbers of
// constraints at which a hub just is and just is not a crowd come up by chance.
START_TEST(crowds_are_told_as_all_others_are)
{
    generator random = generator_new(500 + (uint64_t)_i);
    for (int times = 0; times < (int)cases(60); times++) {
        int constraints = 20 + below(&random, CROWDED - 20);
        zone_case z = crowded_zone(&random, 2 + _i, constraints);
        zone_case plain = zone_new(2 + _i, 300, CROWDED);
        for (int round = 0; round < 2; round++) {
            int sweeps = 1 + below(&random, 40);
            z.zone.solved = round ? below(&random, constraints) : 0;
            copy_zone(&plain, &z);
            int made = zone_solve_again(&z, &tf_gauss_seidel, sweeps);
            ck_assert_int_eq(made, solve_plainly(&plain, sweeps));
            ck_assert_mem_eq(z.displacement, plain.displacement,
                             sizeof(double) * (size_t)((2 + _i) * 300));
            ck_assert_mem_eq(z.constraint, plain.constraint,
                             sizeof(tf_constraint) * (size_t)constraints);
        }
        zone_free(&z);
        zone_free(&plain);
    }
}
END_TEST

// One below, at and above the number that makes a crowd.
START_TEST(hubs_of_all_sizes_are_told)
{
    generator random = generator_new(520 + (uint64_t)_i);
    for (int spokes = 1; spokes <= 140; spokes++) {
        zone_case z = zone_new(2, spokes + 1, spokes);
        zone_case plain = zone_new(2, spokes + 1, spokes);
        z.zone.constraints = spokes;
        z.zone.friction = _i ? 0.3 : 0;
        z.inverse_mass[0] = 0.25;
        for (int i = 0; i < spokes; i++) {
            z.constraint[i] =
                constraint_of(i % 2 ? i + 1 : 0, i % 2 ? 0 : i + 1);
            z.proposal[2 * i + 2] = uniform(&random, -1, 1);
            z.proposal[2 * i + 3] = uniform(&random, -1, 1);
            z.inverse_mass[i + 1] = uniform(&random, 0, 1);
        }
        copy_zone(&plain, &z);
        int made = zone_solve_again(&z, &tf_gauss_seidel, 50);
        ck_assert_int_eq(made, solve_plainly(&plain, 50));
        ck_assert_mem_eq(z.displacement, plain.displacement,
                         sizeof(double) * 2 * (size_t)(spokes + 1));
        zone_free(&z);
        zone_free(&plain);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("response/gauss_seidel");
    TCase *tcase = tcase_create("constraints");
    tcase_add_loop_test(tcase, constraints_are_satisfied_and_do_not_pull, 0, 2);
    tcase_add_test(tcase, constraints_listed_twice_change_nothing);
    tcase_add_loop_test(tcase, no_sweep_raises_the_energy, 0, 2);
    suite_add_tcase(suite, tcase);

    TCase *hand = tcase_create("by hand");
    tcase_add_test(hand, no_more_sweeps_than_allowed);
    tcase_add_test(hand, solved_constraints_wait_until_their_vertices_move);
    tcase_add_loop_test(hand, a_constraint_is_told_of_each_of_its_vertices, 0,
                        16);
    tcase_add_test(hand, impulses_are_taken_back_if_they_push_much_too_much);
    tcase_add_test(hand, friction_is_coulombs);
    tcase_add_test(hand, vertices_have_their_own_friction);
    tcase_add_test(hand, equal_friction_of_vertices_is_that_of_the_zone);
    suite_add_tcase(suite, hand);

    TCase *tcase_long = tcase_create("long");
    tcase_add_test(tcase_long, a_caller_may_cancel);
    tcase_add_test(tcase_long, an_unfinished_agenda_is_not_followed);
    tcase_add_test(tcase_long, work_for_neighbors_counts);
    suite_add_tcase(suite, tcase_long);

    TCase *crowds = tcase_create("crowds");
    tcase_add_loop_test(crowds, crowds_are_told_as_all_others_are, 0, 2);
    tcase_add_loop_test(crowds, hubs_of_all_sizes_are_told, 0, 2);
    suite_add_tcase(suite, crowds);
    return suite;
}
