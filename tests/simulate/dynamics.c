#include "simulate/dynamics.h"

#include "simulate/cloth.h"
#include "support/support.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double step = 0.02;

static tf_dynamics *dynamics_of(const tf_body *body)
{
    tf_dynamics *made = NULL;
    ck_assert_int_eq(tf_dynamics_create(body, step, &made), TF_OK);
    return made;
}

/// A scripted vertex at 0, and a mass at 1, in the plane; without springs.
static tf_body pendulum(void)
{
    tf_body body = {.axes = 2};
    tf_body_add_vertex(&body, (const double[]){0, 0});
    tf_body_add_vertex(&body, (const double[]){1, 0});
    body.mass[1] = 0.5;
    return body;
}

START_TEST(without_elements_inertia_leads)
{
    tf_body body = pendulum();
    tf_dynamics *d = dynamics_of(&body);
    double end[] = {3, 4, 0.1, -0.7};
    ck_assert_int_eq(tf_dynamics_step(d, end, 3), TF_OK);
    const double same[] = {3, 4, 0.1, -0.7};
    for (int i = 0; i < 4; i++)
        ck_assert_double_eq_tol(end[i], same[i], 1e-15);
    tf_dynamics_free(d);
    tf_body_free(&body);
}
END_TEST

START_TEST(linear_elements_take_one_iteration)
{
    tf_body body = pendulum();
    tf_elastic to_nothing = {2, {0, 1}, {-1, 1}, 0, 800};
    tf_body_add_elastic(&body, &to_nothing);
    tf_dynamics *d = dynamics_of(&body);
    double end[] = {3, 4, 1, 2}, weight = step * step * 800;
    ck_assert_int_eq(tf_dynamics_step(d, end, 1), TF_OK);
    ck_assert_double_eq(end[0], 3);
    ck_assert_double_eq_tol(end[2], (0.5 * 1 + weight * 3) / (0.5 + weight),
                            1e-15);
    ck_assert_double_eq_tol(end[3], (0.5 * 2 + weight * 4) / (0.5 + weight),
                            1e-15);
    tf_dynamics_free(d);
    tf_body_free(&body);
}
END_TEST

// Crumpled cloth with a scripted corner -----------------------------------------

static tf_body crumpled(double inertia[])
{
    const tf_material felt = {.density = 1, .stretch = 20, .bend = 0.01};
    tf_body body = {.axes = 3};
    tf_sheet sheet = {4, 4, {0, 0, 0}, {0.25, 0, 0}, {0, 0.25, 0}};
    tf_sheet_add(&body, &sheet, &felt);
    body.mass[0] = 0;
    generator random = generator_new(1);
    for (int i = 0; i < 3 * body.vertices; i++)
        inertia[i] = body.position[i] + uniform(&random, -0.05, 0.05);
    return body;
}

enum {
    MOST = 3 * 25
};

/// What a step is to make least.
static double objective(const tf_body *body, const double inertia[],
                        const double end[])
{
    double sum = tf_body_elastic_energy(body, end);
    for (int i = 0; i < 3 * body->vertices; i++)
        sum += body->mass[i / 3] / (2 * step * step) * (end[i] - inertia[i]) *
               (end[i] - inertia[i]);
    return sum;
}

/// The most by which moving a coordinate a little would change the objective,
/// for the small distance.
static double steepest(const tf_body *body, const double inertia[],
                       double end[])
{
    double most = 0;
    for (int i = 0; i < 3 * body->vertices; i++) {
        if (body->mass[i / 3] == 0)
            continue;
        double before = end[i], small = 1e-5;
        end[i] = before + small;
        double right = objective(body, inertia, end);
        end[i] = before - small;
        double left = objective(body, inertia, end);
        end[i] = before;
        most = fmax(most, fabs(right - left) / (2 * small));
    }
    return most;
}

START_TEST(a_step_ends_where_the_energy_is_least)
{
    double inertia[MOST], end[MOST];
    tf_body body = crumpled(inertia);
    tf_dynamics *d = dynamics_of(&body);
    memcpy(end, inertia, sizeof end);
    double before = steepest(&body, inertia, end);
    ck_assert_int_eq(tf_dynamics_step(d, end, 300), TF_OK);
    double after = steepest(&body, inertia, end);
    ck_assert_msg(after < 1e-6 * before, "%g, then %g", before, after);
    ck_assert_mem_eq(end, inertia, 3 * sizeof *end);
    tf_dynamics_free(d);
    tf_body_free(&body);
}
END_TEST

START_TEST(each_iteration_lowers_the_energy)
{
    double inertia[MOST], end[MOST];
    tf_body body = crumpled(inertia);
    tf_dynamics *d = dynamics_of(&body);
    double before = objective(&body, inertia, inertia);
    for (int iterations = 1; iterations <= 20; iterations++) {
        memcpy(end, inertia, sizeof end);
        ck_assert_int_eq(tf_dynamics_step(d, end, iterations), TF_OK);
        double after = objective(&body, inertia, end);
        ck_assert_double_lt(after, before);
        before = after;
    }
    tf_dynamics_free(d);
    tf_body_free(&body);
}
END_TEST

START_TEST(a_step_does_not_depend_on_those_before)
{
    double inertia[MOST], first[MOST], again[MOST];
    tf_body body = crumpled(inertia);
    tf_dynamics *d = dynamics_of(&body);
    memcpy(first, inertia, sizeof first);
    ck_assert_int_eq(tf_dynamics_step(d, first, 10), TF_OK);
    memcpy(again, body.position, sizeof again);
    ck_assert_int_eq(tf_dynamics_step(d, again, 3), TF_OK);
    memcpy(again, inertia, sizeof again);
    ck_assert_int_eq(tf_dynamics_step(d, again, 10), TF_OK);
    ck_assert_mem_eq(again, first, sizeof first);
    tf_dynamics_free(d);
    tf_body_free(&body);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/dynamics");
    TCase *tcase = tcase_create("steps");
    tcase_add_test(tcase, without_elements_inertia_leads);
    tcase_add_test(tcase, linear_elements_take_one_iteration);
    tcase_add_test(tcase, a_step_ends_where_the_energy_is_least);
    tcase_add_test(tcase, each_iteration_lowers_the_energy);
    tcase_add_test(tcase, a_step_does_not_depend_on_those_before);
    suite_add_tcase(suite, tcase);
    return suite;
}
