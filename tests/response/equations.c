// The equations of a zone, against sums over its constraints.
#include "response/equations.h"

#include "support/support.h"
#include "support/zones.h"

#include <math.h>
#include <stdlib.h>

enum {
    CONSTRAINTS = 12,
    VERTICES = 9,
    AXES = 3
};

static zone_case z;
static tf_equations equations;
static double *vector[2];

static void set_up(void)
{
    generator random = generator_new(1);
    z = zone_random(&random, AXES, VERTICES, CONSTRAINTS, CONSTRAINTS);
    size_t workspace = tf_equations_workspace(AXES, VERTICES, CONSTRAINTS, 2);
    z.zone.workspace = malloc(workspace * sizeof(double));
    ck_assert_ptr_nonnull(z.zone.workspace);
    for (int i = 0; i < AXES * VERTICES; i++)
        z.displacement[i] = z.proposal[i];
    equations = tf_equations_of(&z.zone, 2, vector);
    tf_equations_start(&equations, vector[0], vector[1]);
}

static void tear_down(void)
{
    free(z.zone.workspace);
    zone_free(&z);
}

/// How far the unit impulse of constraint j parts constraint i.
static double entry(const tf_constraint *i, const tf_constraint *j)
{
    double sum = 0;
    for (int a = 0; a < 4; a++)
        for (int b = 0; b < 4; b++)
            if (i->vertex[a] == j->vertex[b])
                for (int k = 0; k < AXES; k++)
                    sum += i->coefficient[a] * i->normal[k] *
                           j->coefficient[b] * j->normal[k] *
                           z.inverse_mass[i->vertex[a]];
    return sum;
}

START_TEST(products_are_those_of_the_scaled_matrix)
{
    double x[CONSTRAINTS] = {0}, product[CONSTRAINTS];
    for (int j = 0; j < CONSTRAINTS; j++) {
        x[j] = 1;
        tf_equations_multiply(&equations, x, product);
        x[j] = 0;
        for (int i = 0; i < CONSTRAINTS; i++) {
            const tf_constraint *one = &z.constraint[i],
                                *other = &z.constraint[j];
            double scaled =
                entry(one, other) / sqrt(entry(one, one) * entry(other, other));
            ck_assert_double_eq_tol(product[i], scaled, 1e-12);
        }
        ck_assert_double_eq_tol(product[j], 1, 1e-12);
    }
}
END_TEST

START_TEST(a_residual_counts_the_impulses_that_there_are)
{
    double none[CONSTRAINTS];
    for (int i = 0; i < CONSTRAINTS; i++) {
        none[i] = vector[1][i];
        z.constraint[i].impulse = i - 3;
    }
    double enough = tf_equations_start(&equations, vector[0], vector[1]);
    double square = tf_equations_dot(&equations, none, none);
    ck_assert_double_eq_tol(enough, 1e-8 * sqrt(square), 1e-15);
    for (int i = 0; i < CONSTRAINTS; i++) {
        const tf_constraint *constraint = &z.constraint[i];
        double expected = none[i];
        for (int j = 0; j < CONSTRAINTS; j++)
            expected -= entry(constraint, &z.constraint[j]) * (j - 3) /
                        sqrt(entry(constraint, constraint));
        ck_assert_double_eq_tol(vector[1][i], expected, 1e-12);
    }
}
END_TEST

START_TEST(impulses_are_left_in_the_constraints_and_applied)
{
    double change[CONSTRAINTS];
    for (int i = 0; i < CONSTRAINTS; i++) {
        vector[0][i] = 0.1 * i;
        z.constraint[i].friction[1] = 1;
    }
    tf_zone_gap_changes(&z.zone, z.proposal, change);
    tf_equations_finish(&equations, vector[0]);
    tf_zone_gap_changes(&z.zone, z.displacement, vector[1]);
    for (int i = 0; i < CONSTRAINTS; i++) {
        const tf_constraint *constraint = &z.constraint[i];
        ck_assert_double_eq_tol(constraint->impulse *
                                    sqrt(entry(constraint, constraint)),
                                0.1 * i, 1e-12);
        ck_assert_double_eq(constraint->friction[1], 0);
        double expected = change[i];
        for (int j = 0; j < CONSTRAINTS; j++)
            expected +=
                entry(constraint, &z.constraint[j]) * z.constraint[j].impulse;
        ck_assert_double_eq_tol(vector[1][i], expected, 1e-12);
    }
}
END_TEST

START_TEST(a_constraint_that_moves_nothing_asks_for_nothing)
{
    for (int i = 0; i < 4; i++)
        z.constraint[5].coefficient[i] = 0;
    tf_equations_start(&equations, vector[0], vector[1]);
    ck_assert_double_eq(vector[1][5], 0);
    tf_equations_multiply(&equations, vector[1], vector[0]);
    ck_assert_double_eq(vector[0][5], 0);
}
END_TEST

START_TEST(residuals_are_small_by_length_or_by_product)
{
    double product[CONSTRAINTS] = {0}, residual[CONSTRAINTS] = {3, 4};
    product[0] = 1;
    ck_assert(tf_equations_are_solved(&equations, residual, product, 5.1));
    ck_assert(!tf_equations_are_solved(&equations, residual, product, 4.9));
    product[0] = 4.9e-6;
    ck_assert(tf_equations_are_solved(&equations, residual, product, 0));
    product[0] = 5.1e-6;
    ck_assert(!tf_equations_are_solved(&equations, residual, product, 0));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("response/equations");
    TCase *tcase = tcase_create("equations");
    tcase_add_checked_fixture(tcase, set_up, tear_down);
    tcase_add_test(tcase, products_are_those_of_the_scaled_matrix);
    tcase_add_test(tcase, a_residual_counts_the_impulses_that_there_are);
    tcase_add_test(tcase, impulses_are_left_in_the_constraints_and_applied);
    tcase_add_test(tcase, a_constraint_that_moves_nothing_asks_for_nothing);
    tcase_add_test(tcase, residuals_are_small_by_length_or_by_product);
    suite_add_tcase(suite, tcase);
    return suite;
}
