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
static void (*before)(int); ///< NULL, or changes that before a trial
static double tried[40][2]; ///< how high trials had vertices 0 and 2 go

/// A chain of scripted vertices at x = 0, 1, ... that are proposed to go up.
static void begin(int vertices)
{
    memset(&follow, 0, sizeof follow);
    memset(&groups, 0, sizeof groups);
    proposal_begin(&made, 2);
    united[0] = united[1] = 0;
    before = NULL;
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

/// Tries until no more is wanted; returns how many trials there were, after
/// that of the whole step.
static int try_all(void)
{
    int trials = 0;
    if (before)
        before(0);
    hold();
    while (tf_follow_learn(&follow, &s.step, &groups)) {
        ck_assert_int_lt(++trials, 40);
        s.step.proposed =
            tf_follow_propose(&follow, &s.step, made.end, &s.surface->edges);
        for (int i = 0; i < 2; i++)
            tried[trials][i] = s.step.proposed[4 * i + 1];
        if (before)
            before(trials);
        hold();
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
    ck_assert_int_le(try_all(), 9);
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
        double part = height(v) / (0.6 * (v - 3));
        ck_assert_double_eq_tol(s.end[2 * v], v - part * 0.2 * (v - 3), 1e-12);
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
    made.inverse_mass[1] = 0.5;
    limit[2 * _i] = 0.5;
    begin_trials();
    try_all();
    ck_assert_double_le(height(2 * _i), 0.5);
    ck_assert_double_eq(height(1), 1);
    ck_assert_double_eq(height(2 - 2 * _i), 1);
    end();
}
END_TEST

// Where a free vertex ends is no matter of its script.
START_TEST(what_is_free_is_not_tried)
{
    begin(2);
    made.inverse_mass[0] = 0.5;
    made.inverse_mass[1] = 2;
    limit[0] = limit[1] = 0.5;
    begin_trials();
    hold();
    ck_assert(!tf_follow_is_held(&s.step));
    ck_assert_int_eq(try_all(), 0);
    ck_assert_double_eq(height(0), 0);
    end();
}
END_TEST

START_TEST(any_vertex_may_be_held)
{
    for (int v = 0; v < 3; v++) {
        begin(3);
        limit[v] = 0.5;
        begin_trials();
        hold();
        ck_assert(tf_follow_is_held(&s.step));
        end();
    }
}
END_TEST

// By 0.412, (hypot(1, 2) - 1) / 3, the edge lets the one that has less far to go
// go a greater part of its way.
START_TEST(the_longer_way_counts)
{
    begin(2);
    add_edges();
    made.end[1] = 3;
    limit[0] = 0.25;
    begin_trials();
    try_all();
    double part = height(0) / 3;
    ck_assert_double_gt(part, 0.25 - 0x1p-7);
    ck_assert_double_eq_tol(height(1), part + (hypot(1, 2) - 1) / 3, 1e-12);
    end();
}
END_TEST

START_TEST(lengths_that_overflow_limit_nothing)
{
    begin(2);
    add_edges();
    made.start[0] = made.end[0] = -0x1p1023;
    made.start[2] = made.end[2] = 0x1p1023;
    limit[0] = 0.5;
    begin_trials();
    try_all();
    ck_assert_double_le(height(0), 0.5);
    ck_assert_double_eq(height(1), 1);
    end();
}
END_TEST

// Rounded, a whole way from the start might end beside the end.
START_TEST(whole_ways_end_where_they_are_proposed_to)
{
    generator random = generator_new(9);
    begin(40);
    for (int i = 0; i < 80; i++) {
        made.start[i] = uniform(&random, -1, 1);
        made.end[i] = uniform(&random, 2, 3);
    }
    limit[0] = 0.4;
    made.start[1] = 0;
    begin_trials();
    ck_assert_int_gt(try_all(), 0);
    ck_assert_mem_eq(s.end + 2, made.end + 2, sizeof *s.end * 78);
    end();
}
END_TEST

START_TEST(companies_may_be_neighbors)
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

static void limit_next(int trial)
{
    limit[1] = trial < 2 ? 1 : 0.4;
}

// A vertex that is held because it goes farther than its company joins that, which is
// tried again as it was.
START_TEST(a_company_grows)
{
    begin(2);
    add_edges();
    made.end[2 * 1 + 1] = 3; // may go farther by 0.412
    limit[0] = 0.55;
    before = limit_next;
    begin_trials();
    ck_assert_int_le(try_all(), 10);
    ck_assert_double_le(height(0), 0.4);
    ck_assert_double_gt(height(0), 0.4 - 0x1p-7);
    ck_assert_double_eq_tol(height(1), 3 * height(0), 1e-12);
    end();
}
END_TEST

/// Vertex 2 is held wherever vertex 1 goes farther than 0.6.
static void limit_last_by_next(int trial)
{
    limit[1] = trial < 2 ? 1 : 0.6;
    limit[2] = trial > 1 && s.step.proposed[3] > 0.6 * 3 ? -1 : 1;
}

// Whoever else is held in that trial, which was not the company's fault.
START_TEST(a_company_that_grows_is_tried_again)
{
    begin(3);
    proposal_add_edge(&made, 0, 1);
    proposal_add_edge(&made, 0, 2);
    made.end[2 * 1 + 1] = 3;
    limit[0] = 0.55;
    before = limit_last_by_next;
    begin_trials();
    try_all();
    ck_assert_double_le(height(0), 0.55);
    ck_assert_double_gt(height(0), 0.55 - 0x1p-7);
    end();
}
END_TEST

/// From the second trial at some height on, or in the first one at rest only,
/// vertex 2 is held with vertex 0.
static void unite_late(int trial)
{
    from = trial >= 2 ? 0 : 2;
    limit[2] = trial >= 2 ? 0.1 : 1;
}

static void unite_at_rest(int trial)
{
    from = trial == 1 ? 0 : 2;
    limit[2] = trial >= 1 ? 0.9 : 1;
}

START_TEST(what_is_held_with_a_company_joins_it)
{
    begin(3);
    limit[0] = 0.3;
    before = unite_late;
    begin_trials();
    united[1] = 2;
    try_all();
    ck_assert_double_le(height(0), 0.1);
    ck_assert_double_gt(height(0), 0.1 - 0x1p-7);
    ck_assert_double_eq(height(2), height(0));
    end();
}
END_TEST

// And it rests first, as the other one did.
START_TEST(what_is_held_alone_begins_a_company)
{
    begin(3);
    limit[0] = 0.3;
    before = unite_at_rest;
    begin_trials();
    united[1] = 2;
    try_all();
    ck_assert_double_eq(tried[1][1], 1);
    ck_assert_double_eq(tried[2][1], 0);
    ck_assert_double_eq(tried[3][1], 0.5);
    ck_assert_double_gt(height(0), 0.3 - 0x1p-7);
    ck_assert_double_le(height(2), 0.9);
    ck_assert_double_gt(height(2), 0.9 - 0x1p-7);
    end();
}
END_TEST

/// The first company is that of vertex 2; later both are in one group.
static void unite_companies(int trial)
{
    from = trial >= 2 ? 0 : 2;
    limit[0] = trial >= 1 ? 0.3 : 1;
}

START_TEST(a_vertex_stays_in_its_company)
{
    begin(3);
    limit[2] = 0.7;
    before = unite_companies;
    begin_trials();
    united[1] = 2;
    try_all();
    ck_assert_double_le(height(0), 0.3);
    ck_assert_double_le(height(2), 0.7);
    ck_assert_double_gt(height(2), 0.7 - 0x1p-7);
    end();
}
END_TEST

// One of two companies is stuck, or none: what is stuck besides is none.
START_TEST(only_what_is_stuck_stays)
{
    begin(3);
    limit[0] = 0.3;
    limit[2] = 0.6;
    begin_trials();
    united[0] = _i;
    united[1] = 3; // which is free
    from = 0;
    try_all();
    for (int v = 0; v < 3; v += 2) {
        double most = v == _i ? 0 : limit[v];
        ck_assert_double_le(height(v), most);
        ck_assert(v == _i || height(v) > most - 0x1p-7);
    }
    ck_assert_double_eq(height(1), 1);
    end();
}
END_TEST

/// After rest and seven halvings nothing helps vertex 0.
static void hold_in_retreat(int trial)
{
    limit[0] = trial > 8 ? -1 : 0.3;
}

// It goes back to where it could go, to the half of that, to the quarter, and to its
// start.  The other one stays where it can.
START_TEST(retreats_go_back_by_halves)
{
    begin(3);
    limit[2] = 0.7;
    before = hold_in_retreat;
    begin_trials();
    ck_assert_int_eq(try_all(), 12);
    ck_assert_double_gt(tried[9][0], 0.3 - 0x1p-7);
    ck_assert_double_eq(tried[10][0], tried[9][0] / 2);
    ck_assert_double_eq(tried[11][0], tried[9][0] / 4);
    ck_assert_double_eq(tried[12][0], 0);
    for (int i = 9; i < 13; i++)
        ck_assert_double_eq(tried[i][1], height(2));
    ck_assert_double_gt(height(2), 0.7 - 0x1p-7);
    end();
}
END_TEST

START_TEST(all_memory_is_told_and_freed)
{
    tf_buffer *all[] = {&follow.company, &follow.number, &follow.fraction,
                        &follow.squeezed, &follow.proposed};
    size_t bytes = 0;
    begin(3);
    begin_trials();
    for (int i = 0; i < 5; i++) {
        ck_assert_uint_gt(all[i]->bytes, 0);
        bytes += all[i]->bytes;
    }
    ck_assert_uint_eq(tf_follow_memory(&follow), bytes);
    end();
    for (int i = 0; i < 5; i++)
        ck_assert_uint_eq(all[i]->bytes, 0);
}
END_TEST

// Nothing is left of the step before: buffers of any content do.
START_TEST(a_step_depends_on_itself_alone)
{
    begin(3);
    limit[0] = 0.3;
    limit[1] = 0.6;
    begin_trials();
    int trials = try_all();
    double ends[6];
    memcpy(ends, s.end, sizeof ends);
    tf_buffer *all[] = {&follow.company, &follow.number, &follow.fraction,
                        &follow.squeezed, &follow.proposed};
    for (int i = 0; i < 5; i++)
        memset(all[i]->data, 0x41, all[i]->bytes);
    s.step.proposed = made.end;
    ck_assert(tf_follow_begin(&follow, &s.step));
    ck_assert_int_eq(try_all(), trials);
    ck_assert_mem_eq(s.end, ends, sizeof ends);
    ck_assert(!((unsigned char *)follow.squeezed.data)[2]);
    end();
}
END_TEST

static generator adverse;

static void limit_anything(int trial)
{
    (void)trial;
    for (int v = 0; v < 40; v++)
        if (below(&adverse, 20) == 0)
            limit[v] = uniform(&adverse, -0.5, 1);
}

// The whole step is the first of 24 trials, and four retreats follow.
START_TEST(the_search_ends_whatever_happens)
{
    adverse = generator_new(10);
    int most = 0;
    for (int i = 0; i < 100; i++) {
        begin(40);
        before = limit_anything;
        begin_trials();
        int trials = try_all();
        most = trials > most ? trials : most;
        end();
    }
    ck_assert_int_eq(most, 23 + 4);
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
    tcase_add_loop_test(tcase, what_is_free_passes_nothing_on, 0, 2);
    tcase_add_test(tcase, what_is_free_is_not_tried);
    tcase_add_test(tcase, any_vertex_may_be_held);
    tcase_add_test(tcase, the_longer_way_counts);
    tcase_add_test(tcase, lengths_that_overflow_limit_nothing);
    tcase_add_test(tcase, whole_ways_end_where_they_are_proposed_to);
    tcase_add_test(tcase, companies_may_be_neighbors);
    tcase_add_test(tcase, a_company_grows);
    tcase_add_test(tcase, a_company_that_grows_is_tried_again);
    tcase_add_test(tcase, what_is_held_with_a_company_joins_it);
    tcase_add_test(tcase, what_is_held_alone_begins_a_company);
    tcase_add_test(tcase, a_vertex_stays_in_its_company);
    tcase_add_loop_test(tcase, only_what_is_stuck_stays, 0, 3);
    tcase_add_test(tcase, retreats_go_back_by_halves);
    tcase_add_test(tcase, all_memory_is_told_and_freed);
    tcase_add_test(tcase, a_step_depends_on_itself_alone);
    tcase_add_test(tcase, the_search_ends_whatever_happens);
    tcase_add_test(tcase, limits_that_pass_on_slowly_can_be_cancelled);
    tcase_add_test(tcase, the_search_ends);
    suite_add_tcase(suite, tcase);
    return suite;
}
