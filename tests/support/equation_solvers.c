#include "support/equation_solvers.h"

#include "support/long_solves.h"
#include "support/zones.h"

#include <math.h>
#include <stdlib.h>

static const tf_zone_solver *solver;

void equation_solver_use(const tf_zone_solver *used)
{
    solver = used;
}

enum {
    ZONES = 200,
    MOST_CONSTRAINTS = 60,
    ENOUGH = 2000 // iterations
};

/// Generic, with fewer equations than coordinates that can be changed.
static zone_case random_zone(generator *random)
{
    int axes = 2 + below(random, 2);
    int constraints = 1 + below(random, MOST_CONSTRAINTS / 3);
    return zone_random(random, axes, 6 + constraints, constraints,
                       MOST_CONSTRAINTS);
}

static void expect_displacement(zone_case *z, const double expected[])
{
    int iterations = zone_solve(z, solver, ENOUGH);
    double distance = zone_distance(z, z->displacement, expected);
    ck_assert_msg(distance < 1e-6 && zone_residual(z) < 1e-6,
                  "%d constraints: %g off, residual %g after %d iterations",
                  z->zone.constraints, distance, zone_residual(z), iterations);
    ck_assert_int_lt(iterations, ENOUGH);
}

static double *least_change(const zone_case *z)
{
    double *expected =
        malloc(sizeof *expected * (size_t)(z->zone.axes * z->zone.vertices));
    ck_assert_ptr_nonnull(expected);
    zone_least_change(z, expected);
    return expected;
}

START_TEST(the_solution_changes_the_proposal_least)
{
    generator random = generator_new(1);
    for (int i = 0; i < (int)cases(ZONES); i++) {
        zone_case z = random_zone(&random);
        double *expected = least_change(&z);
        expect_displacement(&z, expected);
        free(expected);
        zone_free(&z);
    }
}
END_TEST

START_TEST(repeated_constraints_change_nothing)
{
    generator random = generator_new(2);
    for (int i = 0; i < (int)cases(ZONES); i++) {
        zone_case z = random_zone(&random);
        double *expected = least_change(&z);
        int constraints = z.zone.constraints;
        for (int copies = 0; copies < 2 * constraints; copies++)
            zone_duplicate(&z, below(&random, constraints), 1);
        expect_displacement(&z, expected);
        free(expected);
        zone_free(&z);
    }
}
END_TEST

// Of equations that contradict each other, each is half as wrong as they
// differ: the least sum of squares is that of the mean.
START_TEST(contradicting_constraints_meet_halfway)
{
    generator random = generator_new(3);
    for (int i = 0; i < (int)cases(ZONES); i++) {
        zone_case z = random_zone(&random);
        int constraints = z.zone.constraints;
        for (int constraint = 0; constraint < constraints; constraint++)
            z.constraint[constraint].bound *= 1.05;
        double *expected = least_change(&z);
        for (int constraint = 0; constraint < constraints; constraint++) {
            z.constraint[constraint].bound /= 1.05;
            zone_duplicate(&z, constraint, 1.1);
        }
        zone_solve(&z, solver, ENOUGH);
        double distance = zone_distance(&z, z.displacement, expected);
        ck_assert_msg(distance < 1e-5, "%d constraints: %g off", constraints,
                      distance);
        free(expected);
        zone_free(&z);
    }
}
END_TEST

// The constraints of a vertex that is told to move in more directions than
// there are.
START_TEST(too_many_constraints_are_met_by_least_squares)
{
    zone_case z = zone_new(2, 4, 6);
    for (int v = 0; v < 4; v++)
        z.inverse_mass[v] = v == 0;
    for (int i = 0; i < 6; i++)
        z.constraint[i] = (tf_constraint){.vertex = {0, 1, 2, -1},
                                          .coefficient = {1, -0.5, -0.5},
                                          .normal = {cos(i), sin(i), 0},
                                          .bound = 1};
    z.zone.constraints = 6;
    z.proposal[0] = 0.25;
    zone_solve(&z, solver, ENOUGH);
    double residual = zone_residual(&z);
    for (int k = 0; k < 2; k++) { // a least square has no slope
        z.displacement[k] += 1e-3;
        ck_assert_double_gt(zone_residual(&z), residual);
        z.displacement[k] -= 2e-3;
        ck_assert_double_gt(zone_residual(&z), residual);
        z.displacement[k] += 1e-3;
    }
    zone_free(&z);
}
END_TEST

START_TEST(a_solution_is_unchanged_by_solving_again)
{
    generator random = generator_new(4);
    zone_case z = zone_random(&random, 3, 20, 8, 8);
    ck_assert_int_gt(zone_solve(&z, solver, ENOUGH), 0);
    double *first = least_change(&z);
    for (int i = 0; i < 60; i++)
        z.proposal[i] = z.displacement[i];
    ck_assert_int_le(zone_solve(&z, solver, 1), 1);
    ck_assert_double_lt(zone_distance(&z, z.displacement, first), 1e-6);
    free(first);
    zone_free(&z);
}
END_TEST

START_TEST(solving_starts_from_the_given_impulses)
{
    generator random = generator_new(5);
    zone_case z = zone_random(&random, 3, 20, 8, 8);
    zone_solve(&z, solver, ENOUGH);
    double *expected = least_change(&z);
    for (int i = 0; i < 60; i++)
        z.displacement[i] = z.proposal[i];
    for (int i = 0; i < 8; i++)
        z.constraint[i].friction[0] = 1;
    double *workspace = malloc(
        sizeof *workspace * (1 + solver->workspace(3, 20, z.zone.constraints)));
    z.zone.workspace = workspace;
    ck_assert_int_eq(solver->solve(&z.zone), 0);
    ck_assert_double_lt(zone_distance(&z, z.displacement, expected), 1e-6);
    ck_assert_double_eq(z.constraint[7].friction[0], 0);
    free(workspace);
    free(expected);
    zone_free(&z);
}
END_TEST

START_TEST(a_limit_of_iterations_is_kept)
{
    generator random = generator_new(6);
    zone_case z = zone_random(&random, 3, 30, 24, 24);
    ck_assert_int_eq(zone_solve(&z, solver, 3), 3);
    ck_assert_double_lt(zone_residual(&z), 1);
    zone_free(&z);
}
END_TEST

START_TEST(a_caller_may_cancel)
{
    const char *fault = long_solve_fault(solver, 46);
    ck_assert_msg(!fault, "%s", fault);
}
END_TEST

Suite *equation_solver_suite(const char *name, void (*use)(void))
{
    Suite *suite = suite_create(name);
    TCase *tcase = tcase_create("equations");
    tcase_add_checked_fixture(tcase, use, NULL);
    tcase_add_test(tcase, the_solution_changes_the_proposal_least);
    tcase_add_test(tcase, repeated_constraints_change_nothing);
    tcase_add_test(tcase, contradicting_constraints_meet_halfway);
    tcase_add_test(tcase, too_many_constraints_are_met_by_least_squares);
    tcase_add_test(tcase, a_solution_is_unchanged_by_solving_again);
    tcase_add_test(tcase, solving_starts_from_the_given_impulses);
    tcase_add_test(tcase, a_limit_of_iterations_is_kept);
    tcase_add_test(tcase, a_caller_may_cancel);
    suite_add_tcase(suite, tcase);
    return suite;
}
