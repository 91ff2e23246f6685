// The levels: which of them answer, and for how long.
#include "response/resolve.h"

#include "response/gauss_seidel.h"
#include "support/proposals.h"
#include "support/support.h"
#include "support/surface_of.h"

#include <string.h>

static proposal made;
static int calls;

static bool note(void *context, const tf_stage *stage)
{
    ck_assert_ptr_nonnull(stage->name);
    *(int *)context = ++calls;
    return true;
}

static tf_response_report resolve(tf_response_options options)
{
    static double end[3 * PROPOSAL_VERTICES];
    tf_surface *surface = surface_of(&made.mesh);
    tf_resolver *resolver;
    const tf_response_report *lent;
    int context = 0;
    calls = 0;
    options.progress = note;
    options.context = &context;
    memcpy(end, made.end, sizeof end);
    ck_assert_int_eq(tf_resolver_create(surface, &resolver), TF_OK);
    ck_assert_int_eq(tf_step_resolve(resolver, made.mesh.vertices, made.start,
                                     end, made.inverse_mass, &options, &lent,
                                     NULL),
                     TF_OK);
    int rounds = 0;
    for (int level = 0; level < TF_LEVELS; level++)
        rounds += lent->rounds[level];
    ck_assert_int_ge(calls, rounds);
    ck_assert_int_eq(context, calls);
    tf_response_report report = *lent;
    tf_resolver_free(resolver);
    tf_surface_free(surface);
    return report;
}

static void scatter(int stream)
{
    generator random = generator_new((uint64_t)stream);
    proposal_make(&random, BALLS, 3, INSIDE_OUT, &made);
}

START_TEST(each_level_has_its_rounds)
{
    scatter(100);
    tf_response_report report =
        resolve((tf_response_options){.zone_rounds = -1, .rigid = true});
    ck_assert_int_eq(report.rounds[TF_IMPULSES], 0);
    ck_assert_int_eq(report.rounds[TF_ZONES], 0);
    ck_assert_int_gt(report.rounds[TF_RIGID], 0);
    report = resolve((tf_response_options){.impulse_rounds = 1});
    ck_assert_int_eq(report.rounds[TF_IMPULSES], 1);
    report = resolve((tf_response_options){.zone_rounds = -1});
    ck_assert_int_eq(report.rounds[TF_IMPULSES], 0);
    ck_assert_int_eq(report.rounds[TF_ZONES], 0);
    ck_assert_int_eq(report.rounds[TF_RIGID], 0);
    ck_assert_int_gt(report.rounds[TF_FAILSAFE], 0);
    ck_assert_uint_eq(report.constraints, 0);
    report = resolve((tf_response_options){0});
    ck_assert_int_gt(report.rounds[TF_ZONES], 0);
    ck_assert_int_le(report.rounds[TF_ZONES], 20);
    ck_assert_uint_eq(report.constraints, report.contacts);
}
END_TEST

static int do_nothing(tf_zone *zone)
{
    (void)zone;
    return 0;
}

static size_t no_workspace(int axes, int vertices, int constraints)
{
    (void)axes, (void)vertices, (void)constraints;
    return 0;
}

// A round that moves nothing would be repeated in vain.
START_TEST(a_solver_that_does_nothing_is_asked_once)
{
    static const tf_zone_solver idle = {"idle", no_workspace, do_nothing};
    scatter(200);
    tf_response_report report =
        resolve((tf_response_options){.solver = &idle, .separation = -1});
    ck_assert_int_eq(report.rounds[TF_ZONES], 1);
    ck_assert_int_gt(report.rounds[TF_FAILSAFE], 0);
}
END_TEST

/// Moves a zone by next to nothing, but more each time.
static int do_little(tf_zone *zone)
{
    static int times;
    times++;
    for (int i = 0; i < zone->axes * zone->vertices; i++)
        zone->displacement[i] *= 1 - times * 0x1p-20;
    for (int i = 0; i < zone->constraints; i++)
        zone->constraint[i].impulse += 1;
    return 1;
}

// Particles fall through a floor.  Those of the first round are left after each
// of the next five; but if they are few, all rounds are made.
START_TEST(rounds_that_lead_nowhere_end)
{
    static const tf_zone_solver slow = {"slow", no_workspace, do_little};
    proposal_begin(&made, 2);
    proposal_add_vertex(&made, -1, 0, 0);
    proposal_add_vertex(&made, 99, 0, 0);
    proposal_add_edge(&made, 0, 1);
    for (int i = 0; i < 16 + _i; i++) {
        int v = proposal_add_vertex(&made, i, 1, 0);
        made.end[2 * v + 1] = -1;
    }
    tf_response_report report =
        resolve((tf_response_options){.solver = &slow, .separation = -1});
    ck_assert_uint_eq(report.first_contacts, (size_t)(16 + _i));
    ck_assert_int_eq(report.rounds[TF_ZONES], _i == 0 ? 20 : 6);
    ck_assert_int_gt(report.rounds[TF_FAILSAFE], 0);
}
END_TEST

// All of it is carried far away, so that rounding makes it touch itself: the
// first round of the failsafe moves nothing, but unites.
START_TEST(the_failsafe_goes_on_when_nothing_moves)
{
    proposal_begin(&made, 2);
    proposal_add_vertex(&made, 0, 0, 0);
    proposal_add_vertex(&made, 1, 1, 0);
    proposal_add_vertex(&made, 0x1p-1 - 0x1p-40, 0x1p-1 + 0x1p-40, 0);
    proposal_add_edge(&made, 0, 1);
    for (int i = 0; i < 6; i++)
        made.end[i] = made.start[i] + 0x1p20;
    tf_response_report report =
        resolve((tf_response_options){.zone_rounds = -1});
    ck_assert_int_eq(report.rounds[TF_FAILSAFE], 2);
    ck_assert_int_eq(report.resting, 3);
}
END_TEST

static void add_edge(double left, double right, double from, double to,
                     double inverse_mass)
{
    int first = made.mesh.vertices;
    proposal_add_vertex(&made, left, from, 0);
    proposal_add_vertex(&made, right, from, 0);
    proposal_add_edge(&made, first, first + 1);
    for (int v = first; v < first + 2; v++) {
        made.end[2 * v + 1] = to;
        made.inverse_mass[v] = inverse_mass;
    }
}

/// Solves all zones but those whose vertices have an inverse mass of 7.
static int solve_others(tf_zone *zone)
{
    return zone->inverse_mass[0] == 7 ? 0 : tf_gauss_seidel.solve(zone);
}

// Two floors, and edges above them.  No zone helps the one on the left; of the
// others the lower one stops at the floor, and in the next round the upper one at
// the lower one.
START_TEST(contacts_that_nothing_moves_stay_listed)
{
    tf_zone_solver choosy = {"choosy", tf_gauss_seidel.workspace, solve_others};
    proposal_begin(&made, 2);
    add_edge(-9, -3, 0, 0, 0);
    add_edge(-7, -5, 1, -1, 7);
    add_edge(0, 9, 0, 0, 0);
    add_edge(2, 6, 1, -0.5, 1);
    add_edge(3, 5, 1.5, 0.9, 1);
    tf_response_report report =
        resolve((tf_response_options){.solver = &choosy});
    ck_assert_int_eq(report.rounds[TF_ZONES], 3);
    ck_assert_int_eq(report.rounds[TF_FAILSAFE], 1);
    // Two ends of each pair in turn, and those of the left one each time.
    ck_assert_uint_eq(report.contacts, (2 + 2) + (2 + 2) + 2);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("response/levels");
    TCase *tcase = tcase_create("rounds");
    tcase_add_test(tcase, each_level_has_its_rounds);
    tcase_add_test(tcase, a_solver_that_does_nothing_is_asked_once);
    tcase_add_loop_test(tcase, rounds_that_lead_nowhere_end, 0, 2);
    tcase_add_test(tcase, the_failsafe_goes_on_when_nothing_moves);
    tcase_add_test(tcase, contacts_that_nothing_moves_stay_listed);
    suite_add_tcase(suite, tcase);
    return suite;
}
