#include "simulate/relaxation.h"

#include "support/support.h"

#include <math.h>
#include <string.h>

static const double step = 0.01;

static tf_relaxation *relaxation_of(const tf_body *body)
{
    tf_relaxation *made = NULL;
    ck_assert(!body->failed);
    ck_assert_int_eq(tf_relaxation_create(body, step, &made), TF_OK);
    return made;
}

/// In the plane: a scripted edge at the height 0, and above its middle a
/// vertical rod of two masses and a spring; its lower end is vertex 2.
static tf_body rod_on_floor(double stiffness)
{
    static const double place[][2] = {{-1, 0}, {1, 0}, {0, 0.01}, {0, 0.11}};
    tf_body body = {.axes = 2};
    for (int v = 0; v < 4; v++)
        tf_body_add_vertex(&body, place[v]);
    body.mass[2] = 0.5;
    body.mass[3] = 0.25;
    tf_body_add_spring(&body, 2, 3, stiffness);
    return body;
}

/// The lower end of the rod on the floor, without any impulse so far.
static tf_answered_contact contact_of_rod(void)
{
    return (tf_answered_contact){.kind = TF_POINT_EDGE,
                                 .vertex = {2, 0, 1, -1},
                                 .coefficient = {1, -0.5, -0.5},
                                 .normal = {0, 1}};
}

// A spring that is longer than at rest pulls as the dynamics have it pull
// already, even if it is visited since a contact is near that does nothing.
START_TEST(a_spring_pulls_once)
{
    tf_body body = rod_on_floor(5000);
    tf_relaxation *relaxation = relaxation_of(&body);
    tf_answered_contact contact = contact_of_rod();
    double end[] = {-1, 0, 1, 0, 0, 0.02, 0, 0.123}, was[8];
    memcpy(was, end, sizeof end);
    tf_relaxation_begin(relaxation, body.position, end);
    ck_assert_int_eq(tf_relaxation_add(relaxation, 1, &contact), TF_OK);
    tf_relaxation_run(relaxation, 0, end);
    for (int i = 0; i < 8; i++)
        ck_assert_double_eq_tol(end[i], was[i], 1e-12);
    tf_relaxation_free(relaxation);
    tf_body_free(&body);
}
END_TEST

// Without a contact the ends of a step are those of least energy already.
START_TEST(what_is_at_rest_stays)
{
    tf_body body = rod_on_floor(5000);
    tf_relaxation *relaxation = relaxation_of(&body);
    double end[] = {-1, 0, 1, 0, 0, 0.02, 0.001, 0.1205}, was[8];
    memcpy(was, end, sizeof end);
    tf_relaxation_begin(relaxation, body.position, end);
    tf_relaxation_run(relaxation, 0, end);
    ck_assert_mem_eq(end, was, sizeof end);
    tf_relaxation_free(relaxation);
    tf_body_free(&body);
}
END_TEST

// A rod falls by d, and its lower end is stopped.  What is least then is
// m / 2 (u + d)^2 + k h^2 / 2 u^2, for the upper end's way u.
START_TEST(a_spring_knows_of_a_contact)
{
    static const double stiffness[] = {1, 100, 2500, 1e4, 1e6, 1e9};
    const double heavy = _i == 0 ? 1 : 16;
    for (int i = 0; i < 6; i++) {
        const double fall = 0.001;
        tf_body body = rod_on_floor(stiffness[i]);
        body.mass[2] *= heavy;
        body.mass[3] *= heavy;
        tf_relaxation *relaxation = relaxation_of(&body);
        tf_answered_contact contact = contact_of_rod();
        double end[] = {-1, 0, 1, 0, 0, 0.01 - fall, 0, 0.11 - fall};
        double pull = stiffness[i] * step * step;
        double expected = -fall * body.mass[3] / (body.mass[3] + pull);
        tf_relaxation_begin(relaxation, body.position, end);
        ck_assert_int_eq(tf_relaxation_add(relaxation, 1, &contact), TF_OK);
        for (int k = 0; k < 10; k++)
            tf_relaxation_run(relaxation, 0, end);
        ck_assert_double_eq_tol(end[5], 0.01, 2e-3 * fall);
        ck_assert_double_eq_tol(end[7], 0.11 + expected, 2e-3 * fall);
        tf_relaxation_free(relaxation);
        tf_body_free(&body);
    }
}
END_TEST

// A vertex that is about to sink by a and slide by s slides by s - friction a,
// or sticks.
START_TEST(friction_is_coulombs)
{
    for (double friction = 0; friction < 3; friction += 0.25) {
        const double sink = 0.001, along = 0.0012;
        tf_body body = rod_on_floor(1e-6);
        tf_relaxation *relaxation = relaxation_of(&body);
        tf_answered_contact contact = contact_of_rod();
        double end[] = {-1, 0, 1, 0, along, 0.01 - sink, 0, 0.11};
        tf_relaxation_begin(relaxation, body.position, end);
        ck_assert_int_eq(tf_relaxation_add(relaxation, 1, &contact), TF_OK);
        tf_relaxation_run(relaxation, friction, end);
        ck_assert_double_eq_tol(end[4], fmax(0, along - friction * sink), 1e-9);
        ck_assert_double_eq_tol(end[5], 0.01, 1e-9);
        tf_relaxation_free(relaxation);
        tf_body_free(&body);
    }
}
END_TEST

// An impulse that a contact begins with is taken back if it is not needed, and
// a contact never pulls.
START_TEST(a_contact_does_not_hold_what_leaves)
{
    for (int pushed = 0; pushed < 2; pushed++) {
        tf_body body = rod_on_floor(1e-6);
        tf_relaxation *relaxation = relaxation_of(&body);
        tf_answered_contact contact = contact_of_rod();
        double end[] = {-1, 0, 1, 0, 0, 0.012, 0, 0.112};
        contact.impulse = 0.001 * pushed;
        tf_relaxation_begin(relaxation, body.position, end);
        ck_assert_int_eq(tf_relaxation_add(relaxation, 1, &contact), TF_OK);
        tf_relaxation_run(relaxation, 0, end);
        ck_assert_double_eq_tol(end[5], 0.012, 1e-9);
        tf_relaxation_free(relaxation);
        tf_body_free(&body);
    }
}
END_TEST

// However soft a spring is.
START_TEST(springs_have_a_limit)
{
    tf_body body = rod_on_floor(1e-3);
    tf_relaxation *relaxation = relaxation_of(&body);
    double end[] = {-1, 0, 1, 0, 0, -0.1, 0, 0.3};
    tf_relaxation_begin(relaxation, body.position, end);
    tf_relaxation_run(relaxation, 0, end);
    ck_assert_double_eq_tol(end[6] - end[4], 0, 1e-12);
    ck_assert_double_eq_tol(end[7] - end[5], 0.104, 1e-6); // not upside down
    ck_assert_double_eq_tol(0.5 * end[5] + 0.25 * end[7],
                            0.5 * -0.1 + 0.25 * 0.3, 1e-12);
    tf_relaxation_free(relaxation);
    tf_body_free(&body);
}
END_TEST

// What cannot move, and what does not resist, does nothing.
START_TEST(elements_of_no_effect_have_none)
{
    tf_body body = rod_on_floor(5000);
    tf_elastic idle = {2, .vertex = {2, 3}, .weight = {1, -1}};
    tf_body_add_spring(&body, 0, 1, 1000);
    tf_body_add_elastic(&body, &idle);
    tf_relaxation *relaxation = relaxation_of(&body);
    tf_answered_contact contact[] = {contact_of_rod(), contact_of_rod()};
    contact[1] = (tf_answered_contact){.kind = TF_POINT_EDGE,
                                       .vertex = {0, 1, 1, -1},
                                       .coefficient = {1, -0.5, -0.5},
                                       .normal = {0, 1}};
    double end[] = {-1, -0.5, 2, 0, 0, 0.02, 0, 0.12}, was[8];
    memcpy(was, end, sizeof end);
    tf_relaxation_begin(relaxation, body.position, end);
    ck_assert_int_eq(tf_relaxation_add(relaxation, 2, contact), TF_OK);
    tf_relaxation_run(relaxation, 0, end);
    for (int i = 0; i < 8; i++)
        ck_assert_double_eq_tol(end[i], was[i], 1e-12);
    tf_relaxation_free(relaxation);
    tf_body_free(&body);
}
END_TEST

START_TEST(a_spring_of_no_length_stays_finite)
{
    tf_body body = rod_on_floor(5000);
    tf_relaxation *relaxation = relaxation_of(&body);
    tf_answered_contact contact = contact_of_rod();
    double end[] = {-1, 0, 1, 0, 0, 0.02, 0, 0.02};
    tf_relaxation_begin(relaxation, body.position, end);
    ck_assert_int_eq(tf_relaxation_add(relaxation, 1, &contact), TF_OK);
    tf_relaxation_run(relaxation, 0, end);
    for (int i = 4; i < 8; i++)
        ck_assert(isfinite(end[i]));
    tf_relaxation_free(relaxation);
    tf_body_free(&body);
}
END_TEST

START_TEST(none_can_be_freed)
{
    tf_relaxation_free(NULL);
}
END_TEST

// Elements and contacts ----------------------------------------------------------

/// Vertices anywhere, with springs and folds of any four, and contacts of any
/// three with a fourth.
static tf_body tangle_of(generator *random, tf_answered_contact contact[4])
{
    tf_body body = {.axes = 3};
    for (int v = 0; v < 12; v++) {
        double x[3];
        for (int k = 0; k < 3; k++)
            x[k] = uniform(random, -1, 1);
        tf_body_add_vertex(&body, x);
        body.mass[v] = uniform(random, 0.1, 2);
    }
    for (int v = 0; v + 3 < 12; v++) {
        tf_body_add_spring(&body, v, v + 1, uniform(random, 1, 1e5));
        tf_elastic fold = {4, .vertex = {v, v + 1, v + 2, v + 3},
                           .weight = {1, -2, 3, -2},
                           .stiffness = uniform(random, 1, 1e5)};
        tf_body_add_elastic(&body, &fold);
    }
    for (int i = 0; i < 4; i++)
        contact[i] = (tf_answered_contact){
            .vertex = {i, i + 4, i + 5, i + 8},
            .coefficient = {1, -0.2, -0.3, -0.5},
            .normal = {0.6, 0, i % 2 ? 0.8 : -0.8},
            .impulse = uniform(random, 0, 0.1),
            .friction = {0, uniform(random, -0.01, 0.01), 0}};
    return body;
}

// No visit changes the sum of mass times place.
START_TEST(momentum_is_kept)
{
    generator random = generator_new(1);
    for (int i = 0; i < cases(200); i++) {
        tf_answered_contact contact[4];
        tf_body body = tangle_of(&random, contact);
        tf_relaxation *relaxation = relaxation_of(&body);
        double end[36], change[3] = {0}, moved = 0;
        for (int k = 0; k < 36; k++)
            end[k] = body.position[k] + uniform(&random, -0.1, 0.1);
        double was[36];
        memcpy(was, end, sizeof end);
        tf_relaxation_begin(relaxation, body.position, end);
        ck_assert_int_eq(tf_relaxation_add(relaxation, 4, contact), TF_OK);
        tf_relaxation_run(relaxation, 0.3, end);
        for (int k = 0; k < 36; k++) {
            change[k % 3] += body.mass[k / 3] * (end[k] - was[k]);
            moved = fmax(moved, fabs(end[k] - was[k]));
        }
        ck_assert_double_gt(moved, 1e-3);
        for (int k = 0; k < 3; k++)
            ck_assert_double_le(fabs(change[k]), 1e-11);
        tf_relaxation_free(relaxation);
        tf_body_free(&body);
    }
}
END_TEST

enum {
    TANGLE = 36 // coordinates
};

/// So much may be left over: a part of what the ends of a step, 0.004 about where
/// they were, bring in, and more than all sweeps of a relaxation leave.
static const double balanced = 5e-4;

/// The force of all elements on each vertex.
static void add_up_forces(const tf_body *body, const double at[],
                          double force[TANGLE])
{
    memset(force, 0, sizeof *force * TANGLE);
    for (int i = 0; i < body->elastics; i++) {
        const tf_elastic *e = &body->elastic[i];
        double sum[3] = {0};
        for (int j = 0; j < e->count; j++)
            for (int k = 0; k < 3; k++)
                sum[k] += e->weight[j] * at[3 * e->vertex[j] + k];
        double length = hypot(hypot(sum[0], sum[1]), sum[2]);
        double pull = e->stiffness * (1 - e->rest / length);
        for (int j = 0; j < e->count; j++)
            for (int k = 0; k < 3; k++)
                force[3 * e->vertex[j] + k] -= pull * e->weight[j] * sum[k];
    }
}

/// Like a tangle, but soft enough to be relaxed soon, and with elements of three
/// vertices.
static tf_body soft_tangle(generator *random, tf_answered_contact contact[4],
                           double end[TANGLE])
{
    tf_body body = tangle_of(random, contact);
    for (int i = 0; i < body.elastics; i++)
        body.elastic[i].stiffness = uniform(random, 100, 2000);
    for (int v = 0; v + 2 < 12; v += 3) {
        tf_elastic bent = {3, .vertex = {v, v + 1, v + 2}, .weight = {1, -2, 1},
                           .stiffness = 500};
        tf_body_add_elastic(&body, &bent);
    }
    for (int i = 0; i < 4; i++) {
        memset(contact[i].friction, 0, sizeof contact[i].friction);
        contact[i].impulse = uniform(random, 0, 0.0001);
    }
    for (int k = 0; k < TANGLE; k++)
        end[k] = body.position[k] + uniform(random, -0.004, 0.004);
    return body;
}

/// What holds each vertex where it ends: the change of its momentum and of the
/// forces on it since `was`, in units of mass times length.
static void add_up_balance(const tf_body *body, const double was[],
                           const double end[], double balance[TANGLE])
{
    double before[TANGLE], after[TANGLE];
    add_up_forces(body, was, before);
    add_up_forces(body, end, after);
    for (int k = 0; k < TANGLE; k++)
        balance[k] = body->mass[k / 3] * (end[k] - was[k]) -
                     step * step * (after[k] - before[k]);
}

/// By how much the gap of a contact has become wider since the start.
static double widened(const tf_answered_contact *contact, const double start[],
                      const double end[])
{
    double sum = 0;
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++) {
            int j = 3 * contact->vertex[i] + k;
            sum += contact->coefficient[i] * contact->normal[k] *
                   (end[j] - start[j]);
        }
    return sum;
}

/// Expects that only contacts hold vertices, along their normals and where they
/// touch: finds their impulses at their points, which no two of them share.
static void expect_balance(const tf_body *body, tf_answered_contact contact[4],
                           const double was[], const double end[])
{
    double balance[TANGLE];
    add_up_balance(body, was, end, balance);
    for (int i = 0; i < 4; i++) {
        double impulse = 0, wider = widened(&contact[i], body->position, end);
        for (int k = 0; k < 3; k++)
            impulse += balance[3 * i + k] * contact[i].normal[k];
        ck_assert_double_ge(impulse, -balanced);
        ck_assert_double_ge(wider, -balanced);
        ck_assert(impulse < balanced || wider < balanced);
        for (int j = 0; j < 4; j++)
            for (int k = 0; k < 3; k++)
                balance[3 * contact[i].vertex[j] + k] -=
                    contact[i].coefficient[j] * impulse * contact[i].normal[k];
    }
    for (int k = 0; k < TANGLE; k++)
        ck_assert_double_le(fabs(balance[k]), balanced);
}

START_TEST(forces_end_in_balance)
{
    generator random = generator_new(2);
    int tried = 0;
    for (int i = 0; i < cases(80); i++) {
        tf_answered_contact contact[4];
        double end[TANGLE], was[TANGLE];
        tf_body body = soft_tangle(&random, contact, end);
        tf_relaxation *relaxation = relaxation_of(&body);
        memcpy(was, end, sizeof end);
        tf_relaxation_begin(relaxation, body.position, end);
        ck_assert_int_eq(tf_relaxation_add(relaxation, 4, contact), TF_OK);
        for (int k = 0; k < 4; k++)
            tf_relaxation_run(relaxation, 0, end);
        // No spring may be so short that it reaches its limit.
        if (tf_body_stretch(&body, was) < 1.015) {
            expect_balance(&body, contact, was, end);
            tried++;
        }
        tf_relaxation_free(relaxation);
        tf_body_free(&body);
    }
    ck_assert_int_gt(tried, 0);
}
END_TEST

// What no contact is near is not even visited, so that it keeps its last bits.
START_TEST(what_is_free_of_contacts_keeps_its_bits)
{
    generator random = generator_new(4);
    for (int i = 0; i < cases(80); i++) {
        tf_answered_contact contact[4];
        double end[TANGLE], was[TANGLE];
        tf_body body = soft_tangle(&random, contact, end);
        tf_relaxation *relaxation = relaxation_of(&body);
        memcpy(was, end, sizeof end);
        tf_relaxation_begin(relaxation, body.position, end);
        tf_relaxation_run(relaxation, 0.3, end);
        if (tf_body_stretch(&body, was) < 1.04)
            ck_assert_mem_eq(end, was, sizeof end);
        tf_relaxation_free(relaxation);
        tf_body_free(&body);
    }
}
END_TEST

// Whether contacts come one by one or all at once, and again in the next step.
START_TEST(a_step_depends_on_itself_alone)
{
    generator random = generator_new(3);
    tf_answered_contact contact[4];
    double end[TANGLE], ends[2][TANGLE];
    tf_body body = soft_tangle(&random, contact, end);
    tf_relaxation *relaxation = relaxation_of(&body);
    for (int i = 0; i < 2; i++) {
        memcpy(ends[i], end, sizeof end);
        tf_relaxation_begin(relaxation, body.position, end);
        for (size_t own = 0; own < 4; own += i == 0 ? 4 : 1)
            ck_assert_int_eq(
                tf_relaxation_add(relaxation, i == 0 ? 4 : 1, contact + own),
                TF_OK);
        tf_relaxation_run(relaxation, 0.3, ends[i]);
    }
    ck_assert_mem_eq(ends[0], ends[1], sizeof end);
    ck_assert_mem_ne(ends[0], end, sizeof end);
    tf_relaxation_free(relaxation);
    tf_body_free(&body);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/relaxation");
    TCase *tcase = tcase_create("relaxation");
    tcase_add_test(tcase, what_is_at_rest_stays);
    tcase_add_test(tcase, a_spring_pulls_once);
    tcase_add_loop_test(tcase, a_spring_knows_of_a_contact, 0, 2);
    tcase_add_test(tcase, friction_is_coulombs);
    tcase_add_test(tcase, a_contact_does_not_hold_what_leaves);
    tcase_add_test(tcase, springs_have_a_limit);
    tcase_add_test(tcase, elements_of_no_effect_have_none);
    tcase_add_test(tcase, a_spring_of_no_length_stays_finite);
    tcase_add_test(tcase, none_can_be_freed);
    tcase_add_test(tcase, momentum_is_kept);
    tcase_add_test(tcase, forces_end_in_balance);
    tcase_add_test(tcase, what_is_free_of_contacts_keeps_its_bits);
    tcase_add_test(tcase, a_step_depends_on_itself_alone);
    suite_add_tcase(suite, tcase);
    return suite;
}
