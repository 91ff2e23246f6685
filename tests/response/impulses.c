// Rounds of impulses.
#include "response/impulses.h"

#include "response/impulse.h"
#include "support/proposal_steps.h"
#include "support/support.h"
#include "support/watches.h"

#include <math.h>
#include <string.h>

static proposal made;
static proposal_step s;
static int particle; ///< far away
static double displacement[2 * 3 * PROPOSAL_VERTICES];
static tf_constraint constraint[10000];
static tf_contact_gap gap[10000];
static const tf_friction smooth = {0}, rough = {.all = 0.5};

/// Two sheets; the upper one falls through the lower one, a little askew.
static void begin(void)
{
    proposal_begin(&made, 3);
    proposal_add_sheet(&made, 4, 0);
    int upper = proposal_add_sheet(&made, 4, 1);
    for (int v = upper; v < made.mesh.vertices; v++) {
        made.start[3 * v] += 0.3;
        made.end[3 * v] += 0.4;
        made.end[3 * v + 1] += 0.21;
        made.end[3 * v + 2] -= 1.2;
    }
    particle = proposal_add_vertex(&made, 3.3, 9, 9);
    made.end[3 * particle] = 0.1; // in doubles not what its displacement gives
    proposal_step_begin(&s, &made);
}

static void momentum(const double *end, double sum[3])
{
    memset(sum, 0, 3 * sizeof *sum);
    for (int i = 0; i < 3 * made.mesh.vertices; i++)
        sum[i % 3] += (end[i] - made.start[i]) / made.inverse_mass[i / 3];
}

START_TEST(momentum_is_kept)
{
    double before[3], after[3];
    begin();
    made.inverse_mass[3] = 2;
    momentum(made.end, before);
    tf_contacts contacts = proposal_step_contacts(&s);
    ck_assert_uint_gt(contacts.count, 0);
    tf_impulses_round(&s.step, &contacts, &s.rule, rough, displacement,
                      constraint, gap);
    ck_assert_int_gt(proposal_step_changes(&s), 0);
    momentum(s.end, after);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(after[k], before[k], 1e-12);
    proposal_step_free(&s);
}
END_TEST

START_TEST(rounds_clear_the_step)
{
    begin();
    tf_contacts contacts = proposal_step_contacts(&s);
    for (int round = 0; contacts.any && round < 60; round++) {
        tf_impulses_round(&s.step, &contacts, &s.rule, smooth, displacement,
                          constraint, gap);
        contacts = proposal_step_contacts(&s);
    }
    ck_assert(!contacts.any);
    proposal_step_free(&s);
}
END_TEST

START_TEST(vertices_without_contacts_end_as_proposed)
{
    begin();
    tf_contacts contacts = proposal_step_contacts(&s);
    tf_impulses_round(&s.step, &contacts, &s.rule, smooth, displacement,
                      constraint, gap);
    ck_assert_mem_eq(s.end + 3 * (ptrdiff_t)particle,
                     made.end + 3 * (ptrdiff_t)particle, 3 * sizeof(double));
    ck_assert(!proposal_step_has_moved(&s, particle));
    proposal_step_free(&s);
}
END_TEST

START_TEST(a_caller_may_cancel)
{
    watched_call call;
    begin();
    tf_contacts contacts = proposal_step_contacts(&s);
    s.step.watch = watched_begin(&call, -1);
    tf_impulses_round(&s.step, &contacts, &s.rule, smooth, displacement,
                      constraint, gap);
    ck_assert_int_eq(proposal_step_changes(&s), 0);
    s.step.watch = watched_begin(&call, 0);
    tf_impulses_round(&s.step, &contacts, &s.rule, smooth, displacement,
                      constraint, gap);
    ck_assert_uint_ge(watched_work(&call), 4 * contacts.count);
    proposal_step_free(&s);
}
END_TEST

/// Adds impulses to displacements, or pushes.
static void add_up(const tf_contacts *contacts, bool pushes)
{
    tf_bodies bodies = {3, made.inverse_mass, displacement};
    for (size_t i = 0; i < contacts->count; i++) {
        tf_vector normal = tf_vector_at(constraint[i].normal, 0);
        tf_vector friction = tf_vector_at(constraint[i].friction, 0);
        tf_constraint_push(
            &constraint[i],
            pushes ? tf_vector_scaled(gap[i].push, normal)
                   : tf_vector_sum(friction, constraint[i].impulse, normal),
            &bodies);
    }
}

static void expect_explained(const double end[])
{
    for (int i = 0; i < 3 * made.mesh.vertices; i++)
        ck_assert_double_eq_tol(end[i], made.end[i] + displacement[i], 1e-12);
}

// Only what has a rough vertex on both sides is slowed.
START_TEST(vertices_have_their_own_friction)
{
    double own[PROPOSAL_VERTICES] = {0};
    begin();
    for (int v = 0; v < made.mesh.vertices; v++)
        own[v] = made.start[3 * v] < 1.5 ? 0 : 0.5;
    tf_contacts contacts = proposal_step_contacts(&s);
    tf_impulses_round(&s.step, &contacts, &s.rule, (tf_friction){0, own},
                      displacement, constraint, gap);
    int slow = 0, slipping = 0;
    for (size_t i = 0; i < contacts.count; i++) {
        bool rough_side[2] = {false, false};
        for (int j = 0; j < 4 && constraint[i].vertex[j] >= 0; j++)
            rough_side[constraint[i].coefficient[j] < 0] |=
                own[constraint[i].vertex[j]] > 0;
        bool both = rough_side[0] && rough_side[1];
        tf_vector friction = tf_vector_at(constraint[i].friction, 0);
        double size = tf_vector_length(friction);
        ck_assert(both || size == 0);
        slow += size > 0;
        slipping += !both && constraint[i].impulse > 0;
    }
    ck_assert_int_gt(slow, 0);
    ck_assert_int_gt(slipping, 0);
    proposal_step_free(&s);
}
END_TEST

// The motion is made by impulses, and the end by pushes as well.
START_TEST(constraints_and_gaps_are_handed_out)
{
    begin();
    made.inverse_mass[3] = 2;
    s.rule.separation = 9;
    tf_contacts contacts = proposal_step_contacts(&s);
    tf_impulses_round(&s.step, &contacts, &s.rule, rough, displacement,
                      constraint, gap);
    memset(displacement, 0, sizeof displacement);
    add_up(&contacts, false);
    expect_explained(s.unpushed);
    add_up(&contacts, true);
    expect_explained(s.end);
    ck_assert_mem_ne(s.end, s.unpushed, sizeof s.end);
    proposal_step_free(&s);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("response/impulses");
    TCase *tcase = tcase_create("two sheets");
    tcase_add_test(tcase, momentum_is_kept);
    tcase_add_test(tcase, rounds_clear_the_step);
    tcase_add_test(tcase, vertices_without_contacts_end_as_proposed);
    tcase_add_test(tcase, a_caller_may_cancel);
    tcase_add_test(tcase, vertices_have_their_own_friction);
    tcase_add_test(tcase, constraints_and_gaps_are_handed_out);
    suite_add_tcase(suite, tcase);
    return suite;
}
