// The failsafe: who is united, how groups move, and when they rest.
#include "response/failsafe.h"

#include "support/proposal_steps.h"
#include "support/support.h"
#include "support/watches.h"

#include <float.h>
#include <math.h>
#include <string.h>

static proposal made;
static proposal_step s;
static tf_failsafe failsafe;

static void begin(void)
{
    memset(&failsafe, 0, sizeof failsafe);
    proposal_step_begin(&s, &made);
    ck_assert(tf_failsafe_begin(&failsafe, &s.step));
}

static void end(void)
{
    tf_failsafe_free(&failsafe);
    proposal_step_free(&s);
}

/// Answers a contact of a vertex and an edge in the plane.
static void meet(int point, int a, int b)
{
    tf_surface_contact contact = {.kind = TF_POINT_EDGE,
                                  .vertex = {point, a, b, -1}};
    tf_contacts contacts = {.any = true, .count = 1, .contact = &contact};
    tf_failsafe_round(&failsafe, &s.step, &contacts);
}

static tf_response_report account(void)
{
    tf_response_report report = {0};
    memset(s.step.flags, 0, sizeof s.flags);
    report.groups = tf_failsafe_mark(&failsafe, &s.step);
    for (int v = 0; v < s.step.vertices; v++) {
        report.grouped += (s.step.flags[v] & TF_VERTEX_GROUPED) != 0;
        report.resting += (s.step.flags[v] & TF_VERTEX_RESTING) != 0;
    }
    return report;
}

/// An edge from (0, 0) and specks above it; all displacements are multiples of
/// 1/4, the i-th vertex falls by i.
static void make_specks(int specks)
{
    proposal_begin(&made, 2);
    for (int i = 0; i < specks + 2; i++) {
        proposal_add_vertex(&made, i, i < 2 ? 0 : 1, 0);
        made.end[2 * i + 1] -= i;
    }
    proposal_add_edge(&made, 0, 1);
}

static double fall(int vertex)
{
    return made.start[2 * vertex + 1] - s.end[2 * vertex + 1];
}

START_TEST(groups_move_as_their_masses_do)
{
    make_specks(3);
    made.inverse_mass[2] = 0.5;
    begin();
    meet(2, 0, 1);
    // (0 + 1 + 2 * 2) / 4
    for (int v = 0; v < 3; v++)
        ck_assert_double_eq(fall(v), 1.25);
    ck_assert_double_eq(fall(3), 3);
    ck_assert(proposal_step_has_moved(&s, 2) &&
              !proposal_step_has_moved(&s, 3));
    tf_response_report report = account();
    ck_assert_int_eq(report.groups, 1);
    ck_assert_int_eq(report.grouped, 3);
    ck_assert_int_eq(report.resting, 0);

    // With the displacements that they had when the failsafe began.
    meet(3, 0, 1);
    for (int v = 0; v < 4; v++)
        ck_assert_double_eq(fall(v), 8. / 5);
    end();
}
END_TEST

// In space, and of less than a unit of mass: all four go where their momenta lead.
START_TEST(light_groups_move_along_all_axes)
{
    static const tf_surface_contact contact = {.kind = TF_POINT_TRIANGLE,
                                               .vertex = {3, 0, 1, 2}};
    tf_contacts contacts = {.any = true, .count = 1, .contact = &contact};
    proposal_begin(&made, 3);
    for (int v = 0; v < 4; v++) {
        proposal_add_vertex(&made, v % 2, v / 2, v == 3);
        made.inverse_mass[v] = 16;
        for (int k = 0; k < 3; k++)
            made.end[3 * v + k] += v * (k + 1);
    }
    proposal_add_triangle(&made, 0, 1, 2);
    begin();
    tf_failsafe_round(&failsafe, &s.step, &contacts);
    for (int i = 0; i < 12; i++)
        ck_assert_double_eq(s.end[i] - made.start[i], 1.5 * (i % 3 + 1));
    memset(s.step.flags, TF_VERTEX_RIGID, 4);
    ck_assert_int_eq(tf_failsafe_mark(&failsafe, &s.step), 1);
    for (int v = 0; v < 4; v++)
        ck_assert_int_eq(s.step.flags[v], TF_VERTEX_RIGID | TF_VERTEX_GROUPED);
    end();
}
END_TEST

// However often it grows, and in whichever order: the sums are the same.
START_TEST(a_group_moves_as_if_united_at_once)
{
    generator random = generator_new(200);
    for (int times = 0; times < 20; times++) {
        double mass = 0, momentum = 0;
        make_specks(6);
        for (int v = 0; v < 8; v++) {
            made.inverse_mass[v] = uniform(&random, 0.1, 10);
            made.end[2 * v + 1] += uniform(&random, -1, 1);
            mass += 1 / made.inverse_mass[v];
            momentum += (made.end[2 * v + 1] - made.start[2 * v + 1]) /
                        made.inverse_mass[v];
        }
        begin();
        for (int v = 2; v < 8; v++)
            meet(v, v - 1, v - 2);
        for (int v = 0; v < 8; v++)
            ck_assert_double_eq_tol(-fall(v), momentum / mass, 1e-14);
        double one_by_one[16];
        memcpy(one_by_one, s.end, sizeof one_by_one);
        end();

        begin();
        tf_surface_contact contact[6];
        for (int v = 2; v < 8; v++)
            contact[7 - v] = (tf_surface_contact){
                .kind = TF_POINT_EDGE, .vertex = {v, v - 1, v - 2, -1}};
        tf_contacts contacts = {.any = true, .count = 6, .contact = contact};
        tf_failsafe_round(&failsafe, &s.step, &contacts);
        ck_assert_mem_eq(s.end, one_by_one, sizeof one_by_one);
        end();
    }
}
END_TEST

START_TEST(a_group_that_touches_itself_rests_for_good)
{
    make_specks(4);
    begin();
    meet(2, 0, 1);
    meet(2, 0, 1);
    for (int v = 0; v < 3; v++)
        ck_assert_double_eq(fall(v), 0);
    ck_assert_int_eq(account().resting, 3);
    // And so do those that it is united with.
    meet(3, 0, 1);
    ck_assert_double_eq(fall(3), 0);
    ck_assert_double_eq(fall(0), 0);
    ck_assert_int_eq(account().resting, 4);
    meet(0, 4, 5);
    for (int v = 0; v < 6; v++)
        ck_assert_double_eq(fall(v), 0);
    ck_assert_int_eq(account().resting, 6);
    end();
}
END_TEST

// Two contacts of a round: the second is not yet within a group.
START_TEST(only_what_moved_as_one_is_put_to_rest)
{
    make_specks(3);
    begin();
    tf_surface_contact contact[] = {
        {.kind = TF_POINT_EDGE, .vertex = {2, 0, 1, -1}},
        {.kind = TF_POINT_EDGE, .vertex = {0, 1, 2, -1}}};
    tf_contacts contacts = {.any = true, .count = 2, .contact = contact};
    tf_failsafe_round(&failsafe, &s.step, &contacts);
    ck_assert_int_eq(account().resting, 0);
    ck_assert_double_eq(fall(0), 1);
    end();
}
END_TEST

// Scripted vertices -------------------------------------------------------------

START_TEST(scripted_vertices_lead)
{
    make_specks(2);
    made.inverse_mass[1] = 0;
    begin();
    meet(2, 0, 1);
    for (int v = 0; v < 3; v++)
        ck_assert_double_eq(fall(v), 1);
    end();
}
END_TEST

START_TEST(scripted_vertices_that_agree_lead_together)
{
    make_specks(2);
    made.inverse_mass[1] = made.inverse_mass[2] = 0;
    made.end[2 * 2 + 1] = made.start[2 * 2 + 1] - 1;
    begin();
    meet(2, 0, 1);
    for (int v = 0; v < 3; v++)
        ck_assert_double_eq(fall(v), 1);
    ck_assert_int_eq(account().resting, 0);
    end();
}
END_TEST

// By much, and by one ulp.
START_TEST(scripted_vertices_that_disagree_go_where_they_should)
{
    make_specks(3);
    made.inverse_mass[1] = made.inverse_mass[2] = 0;
    if (_i == 1)
        made.end[2 * 2 + 1] = nextafter(made.start[2 * 2 + 1] - 1, 9);
    begin();
    meet(2, 0, 1);
    ck_assert_mem_eq(s.end + 2, made.end + 2, 4 * sizeof(double));
    ck_assert_double_eq(fall(0), 1);
    ck_assert_int_eq(account().resting, 0);

    // But not if they meet.
    meet(2, 0, 1);
    for (int v = 0; v < 3; v++)
        ck_assert_double_eq(fall(v), 0);
    ck_assert_int_eq(account().resting, 3);
    end();
}
END_TEST

// 0.7 - 0.1 is no double.
START_TEST(a_scripted_vertex_whose_displacement_is_no_double_leads)
{
    make_specks(2);
    made.inverse_mass[1] = 0;
    made.start[3] = 0.1;
    made.end[3] = 0.7;
    begin();
    meet(2, 0, 1);
    ck_assert_double_eq(s.end[1], made.start[1] + (0.7 - 0.1));
    ck_assert_double_eq(s.end[3], 0.7);
    ck_assert_double_eq(s.end[5], made.start[5] + (0.7 - 0.1));
    ck_assert_int_eq(account().resting, 0);
    end();
}
END_TEST

// -0 is where it should be, and so is 0.
START_TEST(zeros_keep_their_signs)
{
    make_specks(2);
    for (int v = 0; v < 3; v++)
        made.end[2 * v] = made.start[2 * v] = v == 1 ? 0 : -0.;
    made.end[2] = -0.;
    begin();
    meet(2, 0, 1);
    for (int v = 0; v < 3; v++)
        ck_assert_msg(signbit(s.end[2 * v]) != 0, "vertex %d", v);
    end();
}
END_TEST

START_TEST(scripted_vertices_end_at_their_bits)
{
    make_specks(2);
    made.inverse_mass[1] = 0;
    made.end[3] = made.start[3]; // 0 ...
    made.end[2] = made.start[2];
    made.start[3] = 0.;
    made.end[3] = -0.;
    begin();
    meet(2, 0, 1);
    ck_assert_mem_eq(s.end + 2, made.end + 2, 2 * sizeof(double));
    end();
}
END_TEST

// Huge numbers ------------------------------------------------------------------

START_TEST(no_group_moves_to_infinity)
{
    make_specks(2);
    for (int v = 0; v < 3; v++) {
        made.start[2 * v] = _i == 0 ? -DBL_MAX : DBL_MAX;
        made.end[2 * v] = v == 0 ? DBL_MAX : made.start[2 * v];
    }
    if (_i == 1)
        made.start[0] = -DBL_MAX;
    begin();
    meet(2, 0, 1);
    for (int i = 0; i < 6; i++)
        ck_assert(isfinite(s.end[i]));
    ck_assert_int_eq(account().resting, 3);
    end();
}
END_TEST

// Rounds ------------------------------------------------------------------------

// Each round with a contact unites groups or puts one to rest.
START_TEST(rounds_are_fewer_than_vertices)
{
    generator random = generator_new(100);
    for (int times = 0; times < (int)cases(200); times++) {
        proposal_make(&random, (proposal_shape)below(&random, PROPOSAL_SHAPES),
                      1, SCATTERED, &made);
        begin();
        tf_contacts contacts = proposal_step_contacts(&s);
        int rounds = 0;
        for (; contacts.any && rounds < made.mesh.vertices; rounds++) {
            tf_failsafe_round(&failsafe, &s.step, &contacts);
            contacts = proposal_step_contacts(&s);
        }
        ck_assert_int_lt(rounds, made.mesh.vertices);
        ck_assert(!contacts.any);
        end();
    }
}
END_TEST

// A caller --------------------------------------------------------------------

START_TEST(a_caller_may_cancel)
{
    watched_call call;
    make_specks(1);
    begin();
    s.step.watch = watched_begin(&call, -1);
    meet(2, 0, 1);
    ck_assert_int_eq(account().groups, 0);
    s.step.watch = watched_begin(&call, 0);
    meet(2, 0, 1);
    ck_assert_int_eq(account().groups, 1);
    ck_assert_uint_ge(watched_work(&call), 3);
    end();
}
END_TEST

START_TEST(vertices_get_flags)
{
    make_specks(3);
    begin();
    meet(4, 0, 1);
    account();
    for (int v = 0; v < 5; v++)
        ck_assert_int_eq(s.flags[v], v == 2 || v == 3 ? 0 : TF_VERTEX_GROUPED);
    meet(4, 0, 1);
    account();
    ck_assert_int_eq(s.flags[0], TF_VERTEX_GROUPED | TF_VERTEX_RESTING);
    ck_assert_int_eq(s.flags[2], 0);
    end();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("response/failsafe");
    TCase *tcase = tcase_create("groups");
    tcase_add_test(tcase, groups_move_as_their_masses_do);
    tcase_add_test(tcase, light_groups_move_along_all_axes);
    tcase_add_test(tcase, a_group_moves_as_if_united_at_once);
    tcase_add_test(tcase, a_group_that_touches_itself_rests_for_good);
    tcase_add_test(tcase, only_what_moved_as_one_is_put_to_rest);
    tcase_add_loop_test(tcase, no_group_moves_to_infinity, 0, 2);
    tcase_add_test(tcase, rounds_are_fewer_than_vertices);
    suite_add_tcase(suite, tcase);

    TCase *scripted = tcase_create("scripted vertices");
    tcase_add_test(scripted, scripted_vertices_lead);
    tcase_add_test(scripted, scripted_vertices_that_agree_lead_together);
    tcase_add_loop_test(
        scripted, scripted_vertices_that_disagree_go_where_they_should, 0, 2);
    tcase_add_test(scripted,
                   a_scripted_vertex_whose_displacement_is_no_double_leads);
    tcase_add_test(scripted, zeros_keep_their_signs);
    tcase_add_test(scripted, scripted_vertices_end_at_their_bits);
    suite_add_tcase(suite, scripted);

    TCase *told = tcase_create("a caller");
    tcase_add_test(told, a_caller_may_cancel);
    tcase_add_test(told, vertices_get_flags);
    suite_add_tcase(suite, told);
    return suite;
}
