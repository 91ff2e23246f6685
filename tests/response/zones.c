// Zones: which constraints they have, and what becomes of their answers.
#include "response/zones.h"

#include "response/gauss_seidel.h"
#include "support/proposal_steps.h"
#include "support/support.h"
#include "support/watches.h"

#include <math.h>
#include <string.h>

static proposal made;
static proposal_step s;
static tf_zones zones;
static tf_zone_statistics statistics;

// A solver that only notes what it is given -----------------------------------

static int solved_constraints[8], solved_vertices[8], old_constraints[8],
    solved_zones;

static size_t no_workspace(int axes, int vertices, int constraints)
{
    (void)axes, (void)vertices, (void)constraints;
    return 0;
}

static int note(tf_zone *zone)
{
    if (solved_zones < 8) {
        solved_constraints[solved_zones] = zone->constraints;
        solved_vertices[solved_zones] = zone->vertices;
        old_constraints[solved_zones++] = zone->solved;
    }
    return 1;
}

static const tf_zone_solver noting = {"noting", no_workspace, note};

// A solver that finds no numbers ----------------------------------------------

static int find_no_numbers(tf_zone *zone)
{
    for (int i = 0; i < zone->constraints; i++)
        zone->constraint[i].impulse = NAN;
    for (int i = 0; i < zone->axes * zone->vertices; i++)
        zone->displacement[i] = NAN;
    return 1;
}

static const tf_zone_solver failing = {"failing", no_workspace,
                                       find_no_numbers};

// A solver that moves vertices without an impulse -----------------------------

static int stir(tf_zone *zone)
{
    for (int i = 0; i < zone->axes * zone->vertices; i++)
        zone->displacement[i] += 1;
    return 1;
}

static const tf_zone_solver stirring = {"stirring", no_workspace, stir};

// Scenes ----------------------------------------------------------------------

/// Edges in the plane, level and about 2 long, each at a height; all fall by
/// ten, but those that are scripted stay.
static void add_edge(double x, double height, double inverse_mass)
{
    int a = proposal_add_vertex(&made, x, height, 0);
    int b = proposal_add_vertex(&made, x + 2, height + 0.01, 0);
    proposal_add_edge(&made, a, b);
    for (int v = a; v <= b; v++) {
        made.inverse_mass[v] = inverse_mass;
        made.end[2 * v + 1] -= inverse_mass > 0 ? 10 : 0;
    }
}

static void begin(void)
{
    memset(&zones, 0, sizeof zones);
    statistics = (tf_zone_statistics){.smallest_gap = INFINITY};
    solved_zones = 0;
    proposal_step_begin(&s, &made);
    ck_assert(tf_zones_begin(&zones, &s.step));
}

static void end(void)
{
    tf_zones_free(&zones);
    proposal_step_free(&s);
}

/// One round; returns how many contacts there were.
static size_t go_on_with(const tf_zone_solver *solver, tf_friction friction)
{
    tf_zone_options choice = {
        .solver = solver, .friction = friction, .sweeps = 1000};
    tf_contacts contacts = proposal_step_contacts(&s);
    ck_assert(tf_zones_add(&zones, &s.step, &contacts, &s.rule, &statistics) &&
              tf_zones_solve(&zones, &s.step, &s.rule, &choice, &statistics));
    return contacts.count;
}

static size_t go_on(const tf_zone_solver *solver)
{
    return go_on_with(solver, (tf_friction){0});
}

static int sum(const int number[])
{
    int all = 0;
    for (int z = 0; z < solved_zones; z++)
        all += number[z];
    return all;
}

// Four ends of edges fall upon a floor, each for itself.
START_TEST(scripted_vertices_join_nothing)
{
    proposal_begin(&made, 2);
    add_edge(-5, 0, 0);
    made.start[2] = made.end[2] = 9; // one long floor
    add_edge(-3, 1, 1);
    add_edge(3, 1, 1);
    begin();
    size_t constraints = go_on(&noting);
    ck_assert_int_eq(solved_zones, 4);
    ck_assert_uint_eq((size_t)sum(solved_constraints), constraints);
    for (int z = 0; z < 4; z++)
        ck_assert_int_eq(solved_vertices[z], 3);
    ck_assert_uint_eq(statistics.zones, 4);
    ck_assert_int_eq(zones.constraints, (int)constraints);
    end();
}
END_TEST

START_TEST(vertices_that_move_join_zones)
{
    proposal_begin(&made, 2);
    add_edge(-5, 0, 0);
    made.start[2] = made.end[2] = 9;
    add_edge(-3, 1, 1);
    add_edge(-2, 3, 1);
    made.end[2 * 5 + 1] -= 30; // the upper one overtakes the lower one
    made.end[2 * 4 + 1] -= 30;
    begin();
    go_on(&noting);
    ck_assert_int_eq(solved_zones, 1);
    end();
}
END_TEST

/// An edge that falls from a height of 1 upon a floor, and a separation of 3.
static void begin_near_fall(void)
{
    proposal_begin(&made, 2);
    add_edge(-5, 0, 0);
    made.start[2] = made.end[2] = 9;
    made.start[3] = made.end[3] = 0;
    add_edge(-3, 1, 1);
    begin();
    s.rule.separation = 3;
}

// A script leads one edge through another one.
START_TEST(constraints_of_scripts_are_in_no_zone)
{
    proposal_begin(&made, 2);
    add_edge(-5, 0, 0);
    made.start[2] = made.end[2] = 9;
    add_edge(-3, 1, 1);
    add_edge(3, 1, 0);
    for (int v = 4; v < 6; v++)
        made.end[2 * v + 1] -= 10;
    begin();
    ck_assert_uint_eq(go_on(&noting), 4);
    ck_assert_int_eq(solved_zones, 2);
    ck_assert_int_eq(sum(solved_constraints), 2);
    end();
}
END_TEST

// Two points, the first vertex one of them, fall upon the same edge.
START_TEST(all_vertices_of_a_constraint_join)
{
    static const double place[][2] = {{0.5, 1}, {0, 0}, {2, 0}, {1.5, 1}};
    proposal_begin(&made, 2);
    for (int v = 0; v < 4; v++) {
        proposal_add_vertex(&made, place[v][0], place[v][1], 0);
        made.end[2 * v + 1] -= v % 3 == 0 ? 10 : 0;
    }
    proposal_add_edge(&made, 1, 2);
    begin();
    ck_assert_uint_eq(go_on(&noting), 2);
    ck_assert_int_eq(solved_zones, 1);
    ck_assert_int_eq(solved_vertices[0], 4);
    end();
}
END_TEST

// What a solver does is what the impulses and the friction that are kept do.
START_TEST(impulses_and_friction_are_kept)
{
    proposal_begin(&made, 2);
    add_edge(-5, 0, 0);
    made.start[2] = made.end[2] = 9;
    add_edge(-3, 1, 1);
    for (int v = 2; v < 4; v++)
        made.end[2 * v] += 3;
    begin();
    go_on_with(&tf_gauss_seidel, (tf_friction){.all = 0.1});
    double moved[8] = {0};
    const tf_constraint *all = zones.constraint.data;
    for (int i = 0; i < zones.constraints; i++) {
        ck_assert_double_gt(fabs(all[i].friction[0]), 0.5);
        for (int j = 0; j < 4 && all[i].vertex[j] >= 0; j++)
            for (int k = 0; k < 2; k++)
                moved[2 * all[i].vertex[j] + k] +=
                    made.inverse_mass[all[i].vertex[j]] *
                    all[i].coefficient[j] *
                    (all[i].impulse * all[i].normal[k] + all[i].friction[k]);
    }
    for (int i = 0; i < 8; i++)
        ck_assert_double_eq_tol(s.unpushed[i], made.end[i] + moved[i], 1e-12);
    end();
}
END_TEST

// Buffers may hold anything before.
START_TEST(a_step_depends_on_itself_alone)
{
    double ends[2][8];
    for (int i = 0; i < 2; i++) {
        begin_near_fall();
        tf_buffer *all[] = {
            &zones.by_vertex,    &zones.by_constraint, &zones.mass,
            &zones.displacement, &zones.workspace,     &zones.pushed,
            &zones.constraint,   &zones.gap,           &zones.zone_constraint};
        for (int j = 0; i == 1 && j < 9; j++) {
            ck_assert(tf_buffer_reserve(all[j], 1 << 12, 1));
            memset(all[j]->data, 0x55, all[j]->bytes);
        }
        go_on(&tf_gauss_seidel);
        memcpy(ends[i], s.end, sizeof ends[i]);
        end();
    }
    ck_assert_mem_eq(ends[0], ends[1], sizeof ends[0]);
    ck_assert_mem_ne(ends[0], made.end, sizeof ends[0]);
}
END_TEST

/// How many constraints have a vertex from 4 on.
static int constraints_of_second(void)
{
    const tf_constraint *constraint = zones.constraint.data;
    int count = 0;
    for (int i = 0; i < zones.constraints; i++) {
        bool has = false;
        for (int j = 0; j < 4; j++)
            has |= constraint[i].vertex[j] >= 4;
        count += has;
    }
    return count;
}

START_TEST(only_zones_with_new_constraints_are_solved)
{
    proposal_begin(&made, 2);
    add_edge(-5, 0, 0);
    made.start[2] = made.end[2] = 9;
    add_edge(-3, 1, 1);
    add_edge(3, 1, 1);
    begin();
    size_t constraints = go_on(&noting);
    int first_constraints = sum(solved_constraints);
    ck_assert_int_eq(sum(old_constraints), 0);
    // The first edge stays in contact, the other one is lifted.
    for (int v = 4; v < 6; v++)
        s.end[2 * v + 1] = made.start[2 * v + 1];
    solved_zones = 0;
    size_t more = go_on(&noting);
    ck_assert_uint_gt(more, 0);
    ck_assert_uint_lt(more, constraints);
    ck_assert_int_eq(solved_zones, 2);
    ck_assert_int_eq(zones.constraints, first_constraints + (int)more);
    ck_assert_int_eq(sum(solved_constraints), sum(old_constraints) + (int)more);
    ck_assert_int_gt(constraints_of_second(), 0);
    ck_assert_int_eq(sum(solved_constraints),
                     zones.constraints - constraints_of_second());
    end();
}
END_TEST

START_TEST(zones_start_from_the_base)
{
    proposal_begin(&made, 2);
    add_edge(-5, 0, 0);
    made.start[2] = made.end[2] = 9;
    add_edge(-3, 1, 1);
    add_edge(-3.5, 1.5, 1);
    add_edge(-2.5, 2, 1);
    begin();
    int rounds = 0;
    while (rounds < 20 && go_on(&tf_gauss_seidel) > 0)
        rounds++;
    ck_assert_int_lt(rounds, 20);
    // What its constraints push a vertex is all that it is pushed.
    static double pushed[2 * PROPOSAL_VERTICES];
    memcpy(pushed, made.end, sizeof pushed);
    const tf_constraint *constraint = zones.constraint.data;
    for (int i = 0; i < zones.constraints; i++)
        for (int j = 0; j < 4 && constraint[i].vertex[j] >= 0; j++)
            for (int k = 0; k < 2; k++)
                pushed[2 * constraint[i].vertex[j] + k] +=
                    constraint[i].impulse * constraint[i].coefficient[j] *
                    constraint[i].normal[k] *
                    made.inverse_mass[constraint[i].vertex[j]];
    for (int i = 0; i < 2 * made.mesh.vertices; i++)
        ck_assert_double_eq_tol(s.end[i], pushed[i], 1e-12);
    end();
}
END_TEST

// Contacts at the ends of edges push one vertex each: three edges, one above
// the other, are two zones.
START_TEST(pairs_are_pushed_apart_without_a_motion)
{
    begin_near_fall();
    size_t contacts = go_on(&tf_gauss_seidel);
    const tf_constraint *constraint = zones.constraint.data;
    const tf_contact_gap *gap = zones.gap.data;
    for (size_t i = 0; i < contacts; i++) {
        ck_assert_double_eq(constraint[i].bound, 0);
        ck_assert_double_eq_tol(gap[i].room, (3 - gap[i].start) / 4, 1e-15);
        ck_assert_double_gt(gap[i].push, 0);
    }
    for (int v = 2; v < 4; v++) {
        double height = made.start[2 * v + 1];
        ck_assert_double_eq_tol(s.unpushed[2 * v + 1], height, 1e-12);
        ck_assert_double_eq_tol(s.end[2 * v + 1], height + (3 - height) / 4,
                                1e-12);
    }
    end();
}
END_TEST

// A solver is asked for the motion alone: pushes are made even if it does nothing.
START_TEST(pushes_do_not_depend_on_the_solver)
{
    begin_near_fall();
    int constraints = (int)go_on(&noting);
    ck_assert_int_gt(constraints, 0);
    ck_assert_int_eq(sum(solved_constraints), constraints);
    ck_assert_double_eq_tol(statistics.violation, 10, 1e-12); // all of the fall
    for (int v = 2; v < 4; v++) {
        double height = made.start[2 * v + 1];
        ck_assert_double_eq(s.unpushed[2 * v + 1], made.end[2 * v + 1]);
        ck_assert_double_eq_tol(s.end[2 * v + 1], height + (3 - height) / 4,
                                1e-12);
    }
    end();
}
END_TEST

/// A vertex that falls through two scripted slopes, one below the other, that face
/// each other, and is to keep away from both.
static void begin_fall_on_slopes(void)
{
    static const double slope[][2] = {{-4, 4}, {0.4, -0.4}, {-1, -2}, {4, 3}};
    proposal_begin(&made, 2);
    for (int v = 0; v < 4; v++) {
        proposal_add_vertex(&made, slope[v][0], slope[v][1], 0);
        made.inverse_mass[v] = 0;
    }
    proposal_add_edge(&made, 0, 1);
    proposal_add_edge(&made, 2, 3);
    made.end[2 * proposal_add_vertex(&made, 0, 1, 0) + 1] -= 10;
    begin();
    s.rule.separation = 3;
}

// Pushed from one slope, it slides along the other.
START_TEST(pushes_have_no_friction)
{
    double ends[2][2];
    for (int i = 0; i < 2; i++) {
        begin_fall_on_slopes();
        size_t contacts = go_on_with(&noting, (tf_friction){.all = 5 * i});
        ck_assert_uint_eq(contacts, 2);
        ck_assert_double_ne(s.end[8], s.unpushed[8]);
        memcpy(ends[i], s.end + 8, sizeof ends[i]);
        end();
    }
    ck_assert_mem_eq(ends[0], ends[1], sizeof ends[0]);
}
END_TEST

static double friction_per_mass; ///< that of each vertex, times its mass

static int check_friction(tf_zone *zone)
{
    for (int i = 0; i < zone->vertices; i++)
        ck_assert_double_eq(zone->inverse_mass[zone->vertices + i],
                            friction_per_mass * zone->inverse_mass[i]);
    return note(zone);
}

static const tf_zone_solver checking = {"checking", no_workspace,
                                        check_friction};

START_TEST(vertices_take_their_friction_along)
{
    double friction[8];
    proposal_begin(&made, 2);
    add_edge(-5, 0, 0);
    made.start[2] = made.end[2] = 9;
    for (int i = 0; i < 3; i++)
        add_edge(3 * i - 3, 1, 1);
    for (int v = 2; v < 8; v++)
        made.inverse_mass[v] = v;
    friction_per_mass = 0.25;
    for (int v = 0; v < 8; v++)
        friction[v] = friction_per_mass * made.inverse_mass[v];
    begin();
    ck_assert_uint_gt(go_on_with(&checking, (tf_friction){.own = friction}), 0);
    ck_assert_int_gt(solved_zones, 1);
    end();
}
END_TEST

// A pile of edges, each of which falls through all below it: its lowest gaps are
// made room for by way of all others.
START_TEST(pushes_are_made_in_a_few_sweeps)
{
    proposal_begin(&made, 2);
    add_edge(-5, 0, 0);
    made.start[2] = made.end[2] = 9;
    made.start[3] = made.end[3] = 0;
    for (int i = 1; i <= 20; i++) {
        add_edge(-3 + 0.3 * (i % 2), i, 1);
        made.end[4 * i + 1] -= 2 * i;
        made.end[4 * i + 3] -= 2 * i;
    }
    begin();
    s.rule.separation = 9;
    go_on(&noting);
    ck_assert_uint_eq(statistics.zones, 1);
    ck_assert_uint_eq(statistics.iterations, 1 + 6);
    end();
}
END_TEST

START_TEST(idle_vertices_belong_to_no_zone)
{
    proposal_begin(&made, 2);
    static const double way[][2] = {{.5, .9}, {1, .6}, {1.3, 1.5}};
    int a = proposal_add_vertex(&made, -1.6, 0, 0);
    proposal_add_edge(&made, a, proposal_add_vertex(&made, 1.6, 0, 0));
    made.inverse_mass[0] = made.inverse_mass[1] = 0;
    for (int e = 0; e < 3; e++) {
        a = proposal_add_vertex(&made, -1, 0.3 * (e + 1), 0);
        proposal_add_edge(&made, a,
                          proposal_add_vertex(&made, 1, 0.3 * (e + 1), 0));
        made.end[2 * a + 1] -= way[e][0];
        made.end[2 * a + 3] -= way[e][1];
    }
    begin();
    int rounds = 0;
    while (rounds < 20 && go_on(&tf_gauss_seidel) > 0)
        rounds++;
    ck_assert_int_lt(rounds, 20);
    end();
}
END_TEST

// Zones share scripted vertices, and each numbers them for itself: a floor,
// with a point that falls on its left and an edge and a point on its right.
START_TEST(each_zone_is_a_problem_on_its_own)
{
    proposal_begin(&made, 2);
    add_edge(-5, 0, 0);
    made.start[2] = made.end[2] = 9;
    int vertex = proposal_add_vertex(&made, -4, 1, 0);
    made.end[2 * vertex + 1] -= 10;
    add_edge(2, 1, 1);
    vertex = proposal_add_vertex(&made, 3, 2, 0);
    made.end[2 * vertex + 1] -= 20;
    begin();
    go_on(&tf_gauss_seidel);
    ck_assert_uint_eq(statistics.zones, 2);
    ck_assert_double_lt(statistics.violation, 1e-6);
    for (int v = 0; v < made.mesh.vertices; v++)
        ck_assert_msg(s.end[2 * v + 1] > made.start[2 * v + 1] - 0.05,
                      "vertex %d ends at %g", v, s.end[2 * v + 1]);
    end();
}
END_TEST

// Only where an impulse has changed: the others would be rounded anew, and
// decided again.
START_TEST(only_pushed_vertices_are_moved)
{
    proposal_begin(&made, 2);
    add_edge(-5, 0, 0);
    made.start[2] = made.end[2] = 9;
    add_edge(-3, 1, 1);
    begin();
    ck_assert_uint_gt(go_on(&stirring), 0);
    ck_assert_int_eq(proposal_step_changes(&s), 0);
    ck_assert_mem_eq(s.end, made.end, 8 * sizeof(double));
    end();
}
END_TEST

START_TEST(a_solver_that_fails_moves_nothing)
{
    proposal_begin(&made, 2);
    add_edge(-5, 0, 0);
    made.start[2] = made.end[2] = 9;
    add_edge(-3, 1, 1);
    begin();
    go_on(&failing);
    ck_assert_mem_eq(s.end, made.end,
                     sizeof(double) * 2 * (size_t)made.mesh.vertices);
    ck_assert_int_eq(proposal_step_changes(&s), 0);
    const tf_constraint *constraint = zones.constraint.data;
    for (int i = 0; i < zones.constraints; i++)
        ck_assert_double_eq(constraint[i].impulse, 0);
    end();
}
END_TEST

// A caller --------------------------------------------------------------------

static void make_stack(void)
{
    proposal_begin(&made, 2);
    add_edge(-5, 0, 0);
    made.start[2] = made.end[2] = 9;
    for (int e = 0; e < 40; e++)
        add_edge(-3 + 0.01 * e, 1 + 0.05 * e, 1);
}

// Making and uniting constraints, numbering their zones, ordering, copying and
// taking them back, and measuring what is left.
START_TEST(each_loop_over_constraints_notes_its_work)
{
    watched_call call;
    make_stack();
    begin();
    s.step.watch = watched_begin(&call, 0);
    size_t constraints = go_on(&noting);
    ck_assert_uint_ge(watched_work(&call),
                      (4 + 1 + 1 + 2 + 2 + 2 + 1) * constraints);
    ck_assert_uint_eq(atomic_load(&call.watch.done), constraints);
    end();
}
END_TEST

START_TEST(a_caller_who_cancels_gets_no_zones)
{
    const tf_zone_options choice = {.solver = &noting, .sweeps = 1000};
    watched_call call;
    make_stack();
    begin();
    tf_contacts contacts = proposal_step_contacts(&s);
    ck_assert(tf_zones_add(&zones, &s.step, &contacts, &s.rule, &statistics));
    s.step.watch = watched_begin(&call, -1);
    ck_assert(!tf_zones_add(&zones, &s.step, &contacts, &s.rule, &statistics));
    ck_assert(!tf_zones_solve(&zones, &s.step, &s.rule, &choice, &statistics));
    ck_assert_int_eq(solved_zones, 0);
    ck_assert_int_eq(proposal_step_changes(&s), 0);
    ck_assert_uint_le(watched_work_after(&call), 20);
    end();
}
END_TEST

static int solve_and_cancel(tf_zone *zone)
{
    solved_zones++;
    while (tf_zone_goes_on(zone, TF_WATCHED_WORK))
        ;
    return find_no_numbers(zone);
}

// What the solver leaves in the zone is not looked at.
START_TEST(a_solver_that_is_cancelled_moves_nothing)
{
    static const tf_zone_solver cancelled = {"cancelled", no_workspace,
                                             solve_and_cancel};
    const tf_zone_options choice = {.solver = &cancelled, .sweeps = 1000};
    watched_call call;
    proposal_begin(&made, 2);
    add_edge(-5, 0, 0);
    int speck = proposal_add_vertex(&made, -4, 1, 0);
    made.end[2 * speck + 1] = -1;
    begin();
    tf_contacts contacts = proposal_step_contacts(&s);
    ck_assert(tf_zones_add(&zones, &s.step, &contacts, &s.rule, &statistics));
    s.step.watch = watched_begin(&call, 5);
    ck_assert(!tf_zones_solve(&zones, &s.step, &s.rule, &choice, &statistics));
    ck_assert_int_eq(solved_zones, 1);
    ck_assert_int_eq(proposal_step_changes(&s), 0);
    ck_assert_uint_le(watched_work_after(&call), 20);
    end();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("response/zones");
    TCase *tcase = tcase_create("division");
    tcase_add_test(tcase, scripted_vertices_join_nothing);
    tcase_add_test(tcase, vertices_that_move_join_zones);
    tcase_add_test(tcase, only_zones_with_new_constraints_are_solved);
    tcase_add_test(tcase, constraints_of_scripts_are_in_no_zone);
    tcase_add_test(tcase, all_vertices_of_a_constraint_join);
    tcase_add_test(tcase, impulses_and_friction_are_kept);
    tcase_add_test(tcase, a_step_depends_on_itself_alone);
    suite_add_tcase(suite, tcase);
    tcase = tcase_create("a caller");
    tcase_add_test(tcase, each_loop_over_constraints_notes_its_work);
    tcase_add_test(tcase, a_caller_who_cancels_gets_no_zones);
    tcase_add_test(tcase, a_solver_that_is_cancelled_moves_nothing);
    suite_add_tcase(suite, tcase);

    TCase *answers = tcase_create("answers");
    tcase_add_test(answers, zones_start_from_the_base);
    tcase_add_test(answers, pairs_are_pushed_apart_without_a_motion);
    tcase_add_test(answers, pushes_do_not_depend_on_the_solver);
    tcase_add_test(answers, pushes_have_no_friction);
    tcase_add_test(answers, vertices_take_their_friction_along);
    tcase_add_test(answers, pushes_are_made_in_a_few_sweeps);
    tcase_add_test(answers, idle_vertices_belong_to_no_zone);
    tcase_add_test(answers, each_zone_is_a_problem_on_its_own);
    tcase_add_test(answers, only_pushed_vertices_are_moved);
    tcase_add_test(answers, a_solver_that_fails_moves_nothing);
    suite_add_tcase(suite, answers);
    return suite;
}
