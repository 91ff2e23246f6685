// Scripted vertices: they pass each other, and what is free between them stops
// them as late as can be, where closed forms say.
#include "response/resolve.h"

#include "support/proposals.h"
#include "support/scrambled_workers.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/tangle.h"
#include "surface/check.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static proposal made;
static double end[3 * PROPOSAL_VERTICES], followed[PROPOSAL_VERTICES];
static tf_response_report report;

// Scenes ----------------------------------------------------------------------

static void fix(int first, int count)
{
    for (int v = first; v < first + count; v++)
        made.inverse_mass[v] = 0;
}

static void move(int first, int count, double x, double y, double z)
{
    const double way[] = {x, y, z};
    for (int i = 3 * first; i < 3 * (first + count); i++)
        made.end[i] += way[i % 3];
}

/// Adds a sheet of n x n squares, from `low` to `high` in x and y.
static int add_sheet(int n, double low, double high, double height)
{
    int first = made.mesh.vertices;
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= n; j++)
            proposal_add_vertex(&made, low + (high - low) * i / n,
                                low + (high - low) * j / n, height);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            int a = first + (n + 1) * i + j, b = a + n + 1;
            proposal_add_triangle(&made, a, b, b + 1);
            proposal_add_triangle(&made, a, b + 1, a + 1);
        }
    return first;
}

static void add_square(int a, int b, int c, int d)
{
    proposal_add_triangle(&made, a, b, c);
    proposal_add_triangle(&made, a, c, d);
}

/// Adds a closed box of 8 vertices.
static int add_box(double x, double y, double z, double size)
{
    int v = made.mesh.vertices;
    for (int i = 0; i < 8; i++)
        proposal_add_vertex(&made, x + size * (i & 1), y + size * (i >> 1 & 1),
                            z + size * (i >> 2));
    add_square(v, v + 2, v + 3, v + 1);
    add_square(v + 4, v + 5, v + 7, v + 6);
    add_square(v, v + 1, v + 5, v + 4);
    add_square(v + 2, v + 6, v + 7, v + 3);
    add_square(v, v + 4, v + 6, v + 2);
    add_square(v + 1, v + 3, v + 7, v + 5);
    return v;
}

/// Resolves it, and has it judged, but for what is scripted only.
static tf_status resolve(const tf_response_options *options, tf_error *error)
{
    const tf_response_report *lent;
    tf_surface *surface = surface_of(&made.mesh);
    tf_resolver *resolver;
    ck_assert_int_eq(tf_resolver_create(surface, &resolver), TF_OK);
    memcpy(end, made.end, sizeof end);
    tf_status status =
        tf_step_resolve(resolver, made.mesh.vertices, made.start, end,
                        made.inverse_mass, options, &lent, error);
    if (status == TF_OK) {
        report = *lent;
        memcpy(followed, tf_resolver_followed(resolver),
               sizeof *followed * (size_t)made.mesh.vertices);
    }
    tf_resolver_free(resolver);
    tf_surface_free(surface);
    return status;
}

static void expect_resolved(const tf_response_options *options)
{
    tangle_judge *judge = tangle_judge_new(&made.mesh);
    ck_assert_int_eq(resolve(options, NULL), TF_OK);
    tangle_judge_script(judge, made.inverse_mass);
    ck_assert_int_eq(tangle_count(judge, end), 0);
    tangle_judge_free(judge);
}

/// Expects that the scripted vertices of a range went this part of their way,
/// within 0.01 of it.
static void expect_followed(int first, int count, double fraction)
{
    for (int v = first; v < first + count; v++) {
        ck_assert_msg(followed[v] <= fraction && followed[v] > fraction - 0.01,
                      "vertex %d followed %g, and could %g", v, followed[v],
                      fraction);
        for (int k = 0; k < 3; k++) {
            int i = 3 * v + k;
            ck_assert_double_eq_tol(
                end[i],
                made.start[i] + followed[v] * (made.end[i] - made.start[i]),
                1e-12);
        }
    }
}

// What is scripted only -------------------------------------------------------

static const tf_response_options checked = {.check_start = true};

/// Two scripted triangles, of which one sticks in the other, and a free one that
/// moves elsewhere.
static void make_stuck(void)
{
    proposal_begin(&made, 3);
    proposal_add_vertex(&made, 0, 0, 0);
    proposal_add_vertex(&made, 1, 0, 0);
    proposal_add_vertex(&made, 0, 1, 0);
    proposal_add_vertex(&made, 0.2, 0.2, -0.5);
    proposal_add_vertex(&made, 0.3, 0.2, 0.5);
    proposal_add_vertex(&made, 0.2, 0.3, 0.5);
    proposal_add_triangle(&made, 0, 1, 2);
    proposal_add_triangle(&made, 3, 4, 5);
    fix(0, 6);
    add_sheet(1, 5, 6, 5);
    move(6, 4, 0, 0, -1);
}

START_TEST(what_is_scripted_may_be_tangled)
{
    make_stuck();
    expect_resolved(&checked);
    ck_assert_mem_eq(end, made.end,
                     sizeof *end * 3 * (size_t)made.mesh.vertices);
    ck_assert_int_eq(report.held, 0);
    ck_assert_double_eq(report.followed, 1);
}
END_TEST

// Where one vertex is free, contacts of the others may have let the edge into
// the triangle; where two are, none can.
START_TEST(a_start_is_checked_where_two_vertices_are_free)
{
    for (int free = 0; free < 1 << 6; free++) {
        int others = 0;
        make_stuck();
        for (int v = 0; v < 6; v++)
            made.inverse_mass[v] = free >> v & 1;
        for (int v = 4; v < 6; v++) // the edges from 3 to v pierce 0, 1, 2
            others |= __builtin_popcount(
                          (unsigned)(free & (1 << v | 1 << 3 | 7))) >= 2;
        tf_error error;
        tf_status status = resolve(&checked, &error);
        ck_assert_int_eq(status, others ? TF_START_NOT_CLEAR : TF_OK);
        if (others)
            ck_assert_int_eq(error.subject, TF_EDGE_TRIANGLE_PAIR);
    }
}
END_TEST

/// A speck on a triangle.
START_TEST(a_touching_start_is_checked_where_a_vertex_is_free)
{
    for (int free = 0; free < 1 << 4; free++) {
        proposal_begin(&made, 3);
        proposal_add_vertex(&made, 0, 0, 0);
        proposal_add_vertex(&made, 4, 0, 0);
        proposal_add_vertex(&made, 0, 4, 0);
        proposal_add_triangle(&made, 0, 1, 2);
        proposal_add_vertex(&made, 1, 1, 0);
        move(3, 1, 0, 0, 1);
        for (int v = 0; v < 4; v++)
            made.inverse_mass[v] = free >> v & 1;
        for (int check = 0; check < 2; check++)
            ck_assert_int_eq(
                resolve(&(tf_response_options){.check_start = check}, NULL),
                free ? TF_START_NOT_CLEAR : TF_OK);
    }
}
END_TEST

// They also may be tangled in a step without a free vertex at all.
START_TEST(a_scripted_limb_goes_into_its_body)
{
    proposal_begin(&made, 3);
    add_box(0, 0, 0, 1);
    int limb = add_box(1.5, 0.1, 0.1, 0.8);
    fix(0, 16);
    move(limb, 8, -1.3, 0, 0);
    expect_resolved(&checked);
    ck_assert_mem_eq(end, made.end, sizeof *end * 48);
    ck_assert_uint_eq(report.statistics.candidates, 0);
    // The next step begins there.
    memcpy(made.start, made.end, sizeof made.end);
    move(limb, 8, 0.3, 0.3, 0.3);
    expect_resolved(&checked);
    ck_assert_mem_eq(end, made.end, sizeof *end * 48);
}
END_TEST

// What is squeezed ------------------------------------------------------------

// A sheet at 0.2 between plates at 0 and 1 that move by 0.6 each.  They would
// meet after 1 / 1.2 of the way.
START_TEST(closing_plates_go_until_the_sheet_fills_the_gap)
{
    proposal_begin(&made, 3);
    int low = add_sheet(4, -0.5, 1.5, 0);
    int sheet = add_sheet(1 + 3 * _i, 0, 1, 0.2);
    int high = add_sheet(4, -0.5, 1.5, 1);
    int last = made.mesh.vertices;
    fix(low, sheet - low);
    fix(high, last - high);
    move(low, sheet - low, 0, 0, 0.6);
    move(high, last - high, 0, 0, -0.6);
    expect_resolved(NULL);
    expect_followed(low, sheet - low, 1 / 1.2);
    expect_followed(high, last - high, 1 / 1.2);
    ck_assert_int_eq(report.held, last - (high - sheet));
    for (int v = sheet; v < high; v++)
        ck_assert_double_eq(followed[v], 1);
}
END_TEST

// Jaws that are 1 apart, and come nearer by 1 and by 0.5: they would meet after
// 2/3 of the way.  The box between them is free in all its vertices, so it can be
// pressed flat.
START_TEST(a_gripper_closes_until_the_box_is_flat)
{
    proposal_begin(&made, 3);
    int left = add_box(-1.2, -0.25, -0.25, 1);
    int box = add_box(0, 0, 0, 0.5);
    int right = add_box(0.8, -0.25, -0.25, 1);
    fix(left, 8);
    fix(right, 8);
    move(left, 8, 1, 0, 0);
    move(right, 8, -0.5, 0, 0);
    expect_resolved(NULL);
    expect_followed(left, 8, 2 / 3.);
    expect_followed(right, 8, 2 / 3.);
    ck_assert_int_eq(report.held, 16);
    for (int v = box; v < right; v++)
        ck_assert(end[3 * v] > end[3 * left + 3] &&
                  end[3 * v] < end[3 * right]);
}
END_TEST

// A limb that is 0.4 above a body, and falls by 1.
static int make_limb(void)
{
    proposal_begin(&made, 3);
    add_box(0, 0, 0, 1);
    int sheet = add_sheet(5, -0.25, 1.25, 1.1);
    int limb = add_box(0.1, 0.1, 1.4, 0.8);
    fix(0, 8);
    fix(limb, 8);
    move(limb, 8, 0.1, 0, -1);
    return sheet;
}

START_TEST(a_limb_presses_a_sheet_against_a_body)
{
    int sheet = make_limb(), limb = made.mesh.vertices - 8;
    expect_resolved(NULL);
    expect_followed(limb, 8, 0.4);
    ck_assert_mem_eq(end, made.end, sizeof *end * 24);
    ck_assert_double_eq(report.followed, followed[limb]);
    ck_assert_int_eq(report.held, 8);
    (void)sheet;
}
END_TEST

// A solver that has all vertices of a zone rest, the scripted ones, too.
static size_t no_workspace(int axes, int vertices, int constraints)
{
    (void)axes;
    (void)vertices;
    (void)constraints;
    return 0;
}

static int let_rest(tf_zone *zone)
{
    for (int i = 0; i < zone->axes * zone->vertices; i++)
        zone->displacement[i] = 0;
    for (int i = 0; i < zone->constraints; i++)
        zone->constraint[i].impulse = 1; // a new one, so that they are moved
    return 1;
}

// The limb goes as far as the sheet, and in no trial the failsafe has a round.
START_TEST(what_a_solver_holds_back_needs_no_failsafe)
{
    const tf_zone_solver resting = {"resting", no_workspace, let_rest};
    make_limb();
    int limb = made.mesh.vertices - 8;
    expect_resolved(&(tf_response_options){.solver = &resting});
    ck_assert_int_eq(report.rounds[TF_FAILSAFE], 0);
    expect_followed(limb, 8, 0.3);
    ck_assert_int_eq(report.held, 8);
}
END_TEST

// Without the sheet the limb goes into the body.
START_TEST(a_limb_is_not_stopped_by_its_body)
{
    int sheet = make_limb();
    fix(sheet, 36);
    expect_resolved(NULL);
    ck_assert_mem_eq(end, made.end, sizeof *end * 3 * 52);
}
END_TEST

// Step after step, each to where the script has the limb by then: it stays
// pressed, as near as the first time, and comes back as it is told to.
START_TEST(a_limb_that_was_held_back_catches_up)
{
    make_limb();
    int limb = made.mesh.vertices - 8;
    size_t bytes = sizeof *end * 3 * (size_t)made.mesh.vertices;
    for (int step = 0; step < 6; step++) {
        expect_resolved(&checked);
        for (int v = limb; v < limb + 4; v++) {
            ck_assert_double_gt(end[3 * v + 2], 1);
            ck_assert_double_lt(end[3 * v + 2], 1.01);
        }
        memcpy(made.start, end, bytes);
        memcpy(made.end + 24, end + 24, sizeof *end * 3 * (size_t)(limb - 8));
    }
    move(limb, 8, 0, 0, 2);
    expect_resolved(&checked);
    ck_assert_mem_eq(end + 3 * limb, made.end + 3 * limb, sizeof *end * 24);
    ck_assert_double_eq(report.followed, 1);
}
END_TEST

// A strip along x falls upon a speck under its first square, and a floor.  From
// there on its script has it fall the deeper the farther out, and from vertex to
// vertex it follows that farther, by how much the edge between them is stretched,
// as a part of the longer way.
static double way_of(int i)
{
    return 2 + fmax(0, i - 1);
}

START_TEST(the_far_end_of_a_limb_follows_where_the_shape_allows)
{
    proposal_begin(&made, 3);
    proposal_add_vertex(&made, -9, -9, 0);
    proposal_add_vertex(&made, 9, -9, 0);
    proposal_add_vertex(&made, 0, 9, 0);
    proposal_add_triangle(&made, 0, 1, 2);
    int strip = made.mesh.vertices, length = 4;
    for (int i = 0; i <= length; i++)
        for (int j = 0; j < 2; j++) {
            int v = proposal_add_vertex(&made, i, j - 0.5, 1);
            made.end[3 * v + 2] -= way_of(i);
        }
    for (int i = 0; i < length; i++)
        add_square(strip + 2 * i, strip + 2 * i + 1, strip + 2 * i + 3,
                   strip + 2 * i + 2);
    fix(0, made.mesh.vertices);
    proposal_add_vertex(&made, 0.5, 0.1, 0.5);
    expect_resolved(NULL);
    double fraction = 0.5;
    for (int i = 0; i <= length; i++) {
        if (i > 1)
            fraction += (sqrt(3) - sqrt(2)) / way_of(i); // of the diagonal
        expect_followed(strip + 2 * i, 2, fraction);
    }
    ck_assert_double_gt(fraction, 0.7);
    ck_assert_double_lt(fraction, 1);
}
END_TEST

START_TEST(threads_change_nothing)
{
    static double alone[3 * PROPOSAL_VERTICES];
    make_limb();
    expect_resolved(NULL);
    memcpy(alone, end, sizeof end);
    for (int workers = 2; workers < 5; workers++) {
        tf_parallel parallel = scrambled_workers(&workers);
        expect_resolved(&(tf_response_options){.parallel = &parallel});
        ck_assert_mem_eq(alone, end, sizeof end);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/scripted");
    TCase *only = tcase_create("what is scripted only");
    tcase_add_test(only, what_is_scripted_may_be_tangled);
    tcase_add_test(only, a_start_is_checked_where_two_vertices_are_free);
    tcase_add_test(only, a_touching_start_is_checked_where_a_vertex_is_free);
    tcase_add_test(only, a_scripted_limb_goes_into_its_body);
    suite_add_tcase(suite, only);
    TCase *squeezed = tcase_create("what is squeezed");
    tcase_set_timeout(squeezed, 300);
    tcase_add_loop_test(squeezed,
                        closing_plates_go_until_the_sheet_fills_the_gap, 0, 3);
    tcase_add_test(squeezed, a_gripper_closes_until_the_box_is_flat);
    tcase_add_test(squeezed, a_limb_presses_a_sheet_against_a_body);
    tcase_add_test(squeezed, what_a_solver_holds_back_needs_no_failsafe);
    tcase_add_test(squeezed, a_limb_is_not_stopped_by_its_body);
    tcase_add_test(squeezed, a_limb_that_was_held_back_catches_up);
    tcase_add_test(squeezed,
                   the_far_end_of_a_limb_follows_where_the_shape_allows);
    tcase_add_test(squeezed, threads_change_nothing);
    suite_add_tcase(suite, squeezed);
    return suite;
}
