// How far scripted vertices are tried to go, where a rule says how far they can.
#include "response/follow.h"

#include "support/proposal_steps.h"
#include "support/support.h"
#include "support/watches.h"
#include "surface/surface_memory.h"

#include <math.h>
#include <string.h>

static proposal made;
static proposal_step s;
static tf_follow follow;
static tf_groups groups;
static double limit[PROPOSAL_VERTICES]; ///< how far each vertex can go
static int united[2]; ///< two vertices that the failsafe puts into one group
static double from;   ///< if a trial has one of them go this far, or farther

/// A chain of scripted vertices at x = 0, 1, ... that are proposed to go up.
static void begin(int vertices)
{
    memset(&follow, 0, sizeof follow);
    memset(&groups, 0, sizeof groups);
    proposal_begin(&made, 2);
    united[0] = united[1] = 0;
    for (int v = 0; v < vertices; v++) {
        proposal_add_vertex(&made, v, 0, 0);
        made.inverse_mass[v] = 0;
        made.end[2 * v + 1] = 1;
        limit[v] = 1;
    }
}

static void add_edges(void)
{
    for (int v = 1; v < made.mesh.vertices; v++)
        proposal_add_edge(&made, v - 1, v);
}

static void end(void)
{
    tf_follow_free(&follow);
    tf_buffer_free(&groups.storage);
    proposal_step_free(&s);
}

/// Resolves a trial: holds back, at their start, the vertices that are proposed to
/// go farther than they can.
static void hold(void)
{
    ck_assert(tf_groups_begin(&groups, made.mesh.vertices));
    for (int v = 0; v < made.mesh.vertices; v++) {
        const double *to = s.step.proposed + 2 * v;
        bool holds = to[1] > limit[v] * made.end[2 * v + 1];
        memcpy(s.end + 2 * v, holds ? made.start + 2 * v : to, sizeof *to * 2);
        if ((v == united[0] || v == united[1]) && to[1] >= from)
            tf_groups_unite(&groups, united[0], united[1]);
    }
}

/// Tries until no more is wanted; returns how many trials there were.
static int try_all(void)
{
    int trials = 0;
    hold();
    while (tf_follow_learn(&follow, &s.step, &groups)) {
        s.step.proposed =
            tf_follow_propose(&follow, &s.step, made.end, &s.surface->edges);
        hold();
        trials++;
    }
    return trials;
}

/// Every vertex is in a failsafe group of its own.  A free edge is there as well,
/// without which a mesh might have no elements.
static void begin_trials(void)
{
    int free = proposal_add_vertex(&made, 0, 9, 0);
    proposal_add_edge(&made, free, proposal_add_vertex(&made, 1, 9, 0));
    limit[free] = limit[free + 1] = 1;
    proposal_step_begin(&s, &made);
    ck_assert(tf_follow_begin(&follow, &s.step));
}

static double height(int vertex)
{
    return s.end[2 * vertex + 1];
}

START_TEST(vertices_that_all_can_go_are_not_tried)
{
    begin(3);
    begin_trials();
    ck_assert(!tf_follow_is_held(&s.step));
    ck_assert_int_eq(try_all(), 0);
    end();
}
END_TEST

// Within 2^-7 of what they can, in a trial at rest, seven others, and perhaps one
// that goes back.
START_TEST(the_fraction_is_found_by_bisection)
{
    generator random = generator_new(7);
    for (int i = 0; i < 200; i++) {
        begin(4);
        double most = i < 3 ? i / 2. : uniform(&random, 0, 1);
        limit[1] = most;
        begin_trials();
        hold();
        ck_assert(tf_follow_is_held(&s.step) == (most < 1));
        int trials = try_all();
        ck_assert_int_le(trials, 9);
        ck_assert_int_ge(trials, most < 1 ? 8 : 0);
        ck_assert_double_le(height(1), most);
        ck_assert(most == 1 || height(1) > most - 0x1p-7);
        ck_assert_double_eq(height(0), 1);
        ck_assert_double_eq(height(2), 1);
        end();
    }
}
END_TEST

// One failsafe group is one company, whatever its vertices could do alone.
START_TEST(a_group_goes_together)
{
    begin(3);
    limit[0] = 0.3;
    limit[2] = 0.9;
    begin_trials();
    united[1] = 2;
    from = 0.3;
    try_all();
    ck_assert_double_le(height(0), 0.3);
    ck_assert_double_gt(height(0), 0.3 - 0x1p-7);
    ck_assert_double_eq(height(2), height(0));
    ck_assert_double_eq(height(1), 1);
    const unsigned char *squeezed = follow.squeezed.data;
    ck_assert(squeezed[0] && squeezed[2] && !squeezed[1]);
    end();
}
END_TEST

// What the failsafe has to answer even where they rest keeps them there, by a
// single trial, whatever they could do.
START_TEST(what_is_stuck_stays)
{
    begin(3);
    limit[0] = 0.3;
    begin_trials();
    united[0] = _i;
    united[1] = 3; // which is free
    from = 0;
    int trials = try_all();
    ck_assert_int_eq(trials, _i == 0 ? 1 : 9);
    ck_assert_int_eq(height(0) == 0, _i == 0);
    ck_assert_double_eq(height(1), 1);
    ck_assert_double_eq(height(2), 1);
    end();
}
END_TEST

// Others find limits of their own in the same trials.
START_TEST(companies_are_searched_side_by_side)
{
    generator random = generator_new(8);
    begin(40);
    for (int v = 0; v < 40; v++)
        limit[v] = uniform(&random, 0, 1);
    begin_trials();
    ck_assert_int_le(try_all(), 9);
    for (int v = 0; v < 40; v++) {
        ck_assert_double_le(height(v), limit[v]);
        ck_assert_double_gt(height(v), limit[v] - 0x1p-7);
    }
    end();
}
END_TEST

// Along edges that the script does not stretch, all go the same fraction of their way,
// and along others they may differ by how much it does.
START_TEST(edges_keep_their_shape)
{
    begin(6);
    add_edges();
    made.end[2 * 3 + 1] = 1.25;
    made.end[2 * 4 + 1] = made.end[2 * 5 + 1] = 4;
    limit[0] = 0.25;
    begin_trials();
    try_all();
    double part = height(0);
    ck_assert_double_le(part, 0.25);
    ck_assert_double_gt(part, 0.25 - 0x1p-7);
    ck_assert_double_eq(height(1), part);
    ck_assert_double_eq(height(2), part);
    double third = part + (hypot(1, 0.25) - 1) / 1.25;
    double last = third + (hypot(1, 2.75) - 1) / 4;
    ck_assert_double_eq_tol(height(3) / 1.25, third, 1e-12);
    ck_assert_double_eq_tol(height(4) / 4, last, 1e-12);
    ck_assert_double_eq_tol(height(5) / 4, last, 1e-12);
    ck_assert_double_lt(last, 1);
    end();
}
END_TEST

// A turn stretches nothing, and what rests passes nothing on.
START_TEST(a_limb_turns_as_a_whole)
{
    begin(8);
    add_edges();
    for (int v = 0; v < 8; v++) {
        double x = fmax(0, v - 3);
        made.end[2 * v] = fmin(v, 3) + 0.8 * x;
        made.end[2 * v + 1] = v == 0 ? 1 : 0.6 * x;
    }
    limit[6] = 0.5;
    begin_trials();
    try_all();
    for (int v = 4; v < 8; v++) {
        ck_assert_double_eq_tol(height(v), height(7) * (v - 3) / 4, 1e-12);
        ck_assert_double_le(height(v), 0.3 * (v - 3) + 1e-12);
    }
    ck_assert_double_eq(height(0), 1);
    end();
}
END_TEST

// Vertices that are free, and edges to them, pass nothing on.
START_TEST(what_is_free_passes_nothing_on)
{
    begin(3);
    add_edges();
    made.inverse_mass[1] = 1;
    limit[0] = 0.5;
    begin_trials();
    try_all();
    ck_assert_double_le(height(0), 0.5);
    ck_assert_double_eq(height(1), 1);
    ck_assert_double_eq(height(2), 1);
    end();
}
END_TEST

// A vertex that is held because it goes farther than its company joins that, which is
// tried again as it was.
START_TEST(a_company_grows)
{
    begin(2);
    add_edges();
    made.end[2 * 1 + 1] = 3; // may go farther, by (hypot(1, 2) - 1) / 3 = 0.412
    limit[0] = 0.3;
    limit[1] = 0.6;
    begin_trials();
    try_all();
    ck_assert_double_le(height(0), 0.3);
    ck_assert_double_gt(height(0), 0.3 - 0x1p-7);
    ck_assert_double_le(height(1), 0.6 * 3);
    ck_assert_double_gt(height(1), 0.29 * 3);
    end();
}
END_TEST

// Each time through all edges, only one of them passes its limit on.
START_TEST(limits_that_pass_on_slowly_can_be_cancelled)
{
    watched_call call;
    begin(PROPOSAL_VERTICES - 2);
    add_edges();
    limit[PROPOSAL_VERTICES - 3] = 0.5;
    begin_trials();
    hold();
    ck_assert(tf_follow_learn(&follow, &s.step, &groups));
    s.step.watch = watched_begin(&call, 0);
    ck_assert_ptr_nonnull(
        tf_follow_propose(&follow, &s.step, made.end, &s.surface->edges));
    long all = call.calls;
    ck_assert_int_gt(all, 10);
    for (long last = 1; last <= all; last++) {
        s.step.watch = watched_begin(&call, last);
        ck_assert_ptr_null(
            tf_follow_propose(&follow, &s.step, made.end, &s.surface->edges));
        ck_assert_int_eq(call.calls, last);
        ck_assert_uint_le(watched_work_after(&call), 1);
    }
    end();
}
END_TEST

/// What no fraction helps is held back in the end.
START_TEST(the_search_ends)
{
    begin(3);
    begin_trials();
    for (int v = 0; v < 3; v++)
        limit[v] = -1;
    int trials = try_all();
    ck_assert_int_le(trials, 28);
    ck_assert_mem_eq(s.end, made.start, sizeof *s.end * 6);
    end();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("response/follow");
    TCase *tcase = tcase_create("follow");
    tcase_add_test(tcase, vertices_that_all_can_go_are_not_tried);
    tcase_add_test(tcase, the_fraction_is_found_by_bisection);
    tcase_add_test(tcase, a_group_goes_together);
    tcase_add_loop_test(tcase, what_is_stuck_stays, 0, 2);
    tcase_add_test(tcase, companies_are_searched_side_by_side);
    tcase_add_test(tcase, edges_keep_their_shape);
    tcase_add_test(tcase, a_limb_turns_as_a_whole);
    tcase_add_test(tcase, what_is_free_passes_nothing_on);
    tcase_add_test(tcase, a_company_grows);
    tcase_add_test(tcase, limits_that_pass_on_slowly_can_be_cancelled);
    tcase_add_test(tcase, the_search_ends);
    suite_add_tcase(suite, tcase);
    return suite;
}
