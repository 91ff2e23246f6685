// Rigid zones: momenta, shapes, scripted vertices.
#include "response/rigid.h"

#include "response/options.h"
#include "support/proposal_steps.h"
#include "support/support.h"
#include "support/watches.h"

#include <math.h>
#include <string.h>

static proposal made;
static proposal_step s;
static tf_rigid rigid;

enum {
    BODY = 6 ///< vertices in the body; one more is alone
};

/// Vertices anywhere, pushed anywhere; the first are united two by two.
static void unite_random(generator *random, int axes, double far)
{
    proposal_begin(&made, axes);
    for (int v = 0; v < BODY + 1; v++) {
        proposal_add_vertex(&made, uniform(random, 0, 1), uniform(random, 0, 1),
                            uniform(random, 0, 1));
        made.inverse_mass[v] = uniform(random, 0.5, 2);
        for (int k = 0; k < axes; k++)
            made.end[axes * v + k] += uniform(random, -far, far);
    }
    proposal_add_edge(&made, 0, 1);
    memset(&rigid, 0, sizeof rigid);
    proposal_step_begin(&s, &made);
    ck_assert(tf_rigid_begin(&rigid, &s.step));
}

/// Begins anew with vertices of the body that have been pushed apart.
static void push_apart(generator *random, double far)
{
    for (int i = 0; i < made.mesh.axes * BODY; i++)
        s.end[i] += uniform(random, -far, far);
    tf_rigid_free(&rigid);
    ck_assert(tf_rigid_begin(&rigid, &s.step));
}

static void answer(void)
{
    tf_surface_contact contact[] = {
        {.kind = TF_EDGE_EDGE, .vertex = {0, 1, 2, 3}},
        {.kind = TF_EDGE_EDGE, .vertex = {2, 3, 4, 5}}};
    tf_contacts contacts = {.any = true, .count = 2, .contact = contact};
    tf_rigid_round(&rigid, &s.step, &contacts);
}

static void end(void)
{
    tf_rigid_free(&rigid);
    proposal_step_free(&s);
}

static double distance(const double *x, int a, int b)
{
    double sum = 0;
    for (int k = 0; k < made.mesh.axes; k++) {
        double d = x[made.mesh.axes * a + k] - x[made.mesh.axes * b + k];
        sum += d * d;
    }
    return sqrt(sum);
}

START_TEST(shapes_are_kept)
{
    generator random = generator_new(100 + (uint64_t)_i);
    for (int times = 0; times < (int)cases(200); times++) {
        unite_random(&random, 2 + _i, 2);
        answer();
        for (int a = 0; a < BODY; a++)
            for (int b = 0; b < a; b++)
                ck_assert_double_eq_tol(distance(s.end, a, b),
                                        distance(made.start, a, b), 1e-12);
        ck_assert_mem_eq(s.end + (ptrdiff_t)made.mesh.axes * BODY,
                         made.end + (ptrdiff_t)made.mesh.axes * BODY,
                         sizeof(double) * (size_t)made.mesh.axes);
        end();
    }
}
END_TEST

/// Momentum, and angular momentum with the arms at the start.
static void add_momenta(const double *ends, double sum[6])
{
    memset(sum, 0, 6 * sizeof *sum);
    for (int v = 0; v < BODY; v++) {
        double x[3];
        tf_vector d = tf_step_displacement(&s.step, v, ends);
        for (int k = 0; k < 3; k++)
            x[k] = k < s.step.axes ? made.start[s.step.axes * v + k] : 0;
        for (int k = 0; k < 3; k++) {
            int i = (k + 1) % 3, j = (k + 2) % 3;
            sum[k] += d.x[k] / made.inverse_mass[v];
            sum[3 + k] +=
                (x[i] * d.x[j] - x[j] * d.x[i]) / made.inverse_mass[v];
        }
    }
}

// The angular one in the first order: turns are small.
START_TEST(momenta_are_kept)
{
    generator random = generator_new(200 + (uint64_t)_i);
    for (int times = 0; times < (int)cases(200); times++) {
        double before[6], after[6];
        unite_random(&random, 2 + _i, 1e-5);
        push_apart(&random, 1e-5);
        add_momenta(made.end, before);
        answer();
        add_momenta(s.end, after);
        ck_assert_mem_eq(s.end, s.unpushed,
                         sizeof *s.end * (size_t)(made.mesh.axes * BODY));
        for (int k = 0; k < 6; k++)
            ck_assert_double_eq_tol(after[k], before[k], k < 3 ? 1e-14 : 1e-8);
        end();
    }
}
END_TEST

START_TEST(zones_with_scripted_vertices_stay_as_they_are)
{
    generator random = generator_new(300);
    unite_random(&random, 3, 2);
    push_apart(&random, 2);
    made.inverse_mass[4] = 0;
    double before[3 * (BODY + 1)];
    memcpy(before, s.end, sizeof before);
    answer();
    ck_assert_mem_eq(s.end, before, sizeof before);
    ck_assert_mem_eq(s.unpushed, made.end, sizeof before);
    end();
}
END_TEST

// All in a line: about it there is no inertia, but for rounding.
START_TEST(rods_only_move_along)
{
    generator random = generator_new(400);
    for (int times = 0; times < 50; times++) {
        double way[3], mean[3] = {0, 0, 0}, mass = 0;
        unite_random(&random, 3, 1);
        for (int k = 0; k < 3; k++)
            way[k] = times == 0 ? k == 0 : uniform(&random, -1, 1);
        for (int v = 0; v < BODY; v++) {
            mass += 1 / made.inverse_mass[v];
            for (int k = 0; k < 3; k++) {
                double d = made.end[3 * v + k] - made.start[3 * v + k];
                mean[k] += d / made.inverse_mass[v];
                made.start[3 * v + k] = v * way[k];
                made.end[3 * v + k] = v * way[k] + d;
            }
        }
        memcpy(s.end, made.end, sizeof s.end);
        memcpy(s.unpushed, made.end, sizeof s.unpushed);
        tf_rigid_free(&rigid);
        ck_assert(tf_rigid_begin(&rigid, &s.step));
        answer();
        for (int i = 0; i < 3 * BODY; i++)
            ck_assert_double_eq_tol(s.end[i] - made.start[i],
                                    mean[i % 3] / mass, 1e-12);
        end();
    }
}
END_TEST

START_TEST(a_caller_may_cancel)
{
    watched_call call;
    generator random = generator_new(900);
    unite_random(&random, 3, 1);
    s.step.watch = watched_begin(&call, -1);
    answer();
    ck_assert_int_eq(proposal_step_changes(&s), 0);
    s.step.watch = watched_begin(&call, 0);
    answer();
    ck_assert_int_eq(proposal_step_changes(&s), BODY);
    ck_assert_uint_ge(watched_work(&call), 3 * 2);
    for (int v = 0; v < BODY + 1; v++)
        ck_assert_int_eq(s.flags[v], v < BODY ? TF_VERTEX_RIGID : 0);
    end();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("response/rigid");
    TCase *tcase = tcase_create("bodies");
    tcase_add_loop_test(tcase, shapes_are_kept, 0, 2);
    tcase_add_loop_test(tcase, momenta_are_kept, 0, 2);
    tcase_add_test(tcase, zones_with_scripted_vertices_stay_as_they_are);
    tcase_add_test(tcase, rods_only_move_along);
    tcase_add_test(tcase, a_caller_may_cancel);
    suite_add_tcase(suite, tcase);
    return suite;
}
