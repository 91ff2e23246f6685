// Steps that are drafted first, and answered again from the same start.
#include "response/resolve.h"

#include "fast/vectorized.h"
#include "response/limit.h"
#include "support/proposals.h"
#include "support/scrambled_workers.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/tangle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static proposal made;
static tf_surface *surface;
static tf_resolver *resolver;
static tf_response_report report;

static void begin(void)
{
    surface = surface_of(&made.mesh);
    ck_assert_int_eq(tf_resolver_create(surface, &resolver), TF_OK);
}

static void finish(void)
{
    tf_resolver_free(resolver);
    tf_surface_free(surface);
}

static tf_status try(const double start[], double end[],
                     tf_response_options options)
{
    const tf_response_report *lent;
    options.size = sizeof options;
    tf_status status =
        tf_step_resolve(resolver, made.mesh.vertices, start, end,
                        made.inverse_mass, &options, &lent, NULL);
    if (status == TF_OK)
        report = *lent;
    return status;
}

/// Resolves what is proposed; returns where it ends, in static storage.
static const double *answer(tf_response_options options)
{
    static double end[3 * PROPOSAL_VERTICES];
    memcpy(end, made.end, sizeof end);
    ck_assert_int_eq(try(made.start, end, options), TF_OK);
    return end;
}

static const tf_response_options drafted = {.draft = true};
static const tf_response_options again = {.again = true};

/// What the usual resolver makes of the step, to be freed.
static double *answer_of_new_resolver(tf_response_options options)
{
    double *end = malloc(sizeof made.end);
    tf_surface *other_surface = surface;
    tf_resolver *other = resolver;
    begin();
    memcpy(end, answer(options), sizeof made.end);
    finish();
    surface = other_surface;
    resolver = other;
    return end;
}

static int tangles_of(const double start[], const double end[])
{
    tangle_judge *judge = tangle_judge_new(&made.mesh);
    tangle_judge_script(judge, made.inverse_mass);
    int count =
        tangle_count(judge, end) +
        (made.mesh.vertices <= 30 ? tangle_count_in_step(judge, start, end)
                                  : 0);
    tangle_judge_free(judge);
    return count;
}

static void make_wild(int number)
{
    generator random = generator_new((uint64_t)number);
    proposal_make(&random, (proposal_shape)(number / PROPOSAL_WAYS), 2,
                  (proposal_way)(number % PROPOSAL_WAYS), &made);
    if (below(&random, 2))
        proposal_weigh(&random, &made);
}

/// Proposes half of the way, and puts the whole way into `whole`.
static void halve(double whole[])
{
    memcpy(whole, made.end, sizeof made.end);
    for (int i = 0; i < made.mesh.axes * made.mesh.vertices; i++)
        made.end[i] = (made.start[i] + made.end[i]) / 2;
}

// What a draft does -------------------------------------------------------------

// A step that needs no answer is the proposal, in a draft and then again.
START_TEST(clear_steps_are_drafted_bit_for_bit)
{
    proposal_begin(&made, 2);
    proposal_add_edge(&made, proposal_add_vertex(&made, -4, 0, 0),
                      proposal_add_vertex(&made, 4, 0, 0));
    proposal_add_vertex(&made, -0.5, 1, 0);
    made.end[5] -= 0.75;
    begin();
    ck_assert_mem_eq(answer(drafted), made.end, sizeof(double) * 6);
    ck_assert_uint_eq(report.first_contacts, 0);
    ck_assert_mem_eq(answer(again), made.end, sizeof(double) * 6);
    finish();
}
END_TEST

// Neither rigid zones nor the failsafe have a part in it, so nothing scripted is
// held back.
START_TEST(drafts_are_of_impulses_and_zones)
{
    make_wild(_i);
    begin();
    answer((tf_response_options){
        .draft = true, .rigid = true, .impulse_rounds = 1, .zone_rounds = 2});
    ck_assert_int_eq(report.rounds[TF_RIGID], 0);
    ck_assert_int_eq(report.rounds[TF_FAILSAFE], 0);
    ck_assert_int_eq(report.held, 0);
    ck_assert_int_le(report.rounds[TF_ZONES], 2);
    ck_assert_int_eq(report.rounds[TF_ZONES] + report.rounds[TF_IMPULSES] > 0,
                     report.first_contacts > 0);
    finish();
}
END_TEST

// Answers after a draft ---------------------------------------------------------

static void expect_the_same_bits(const double half[], const double whole[],
                                 const double end[])
{
    int workers = 3;
    tf_parallel parallel = scrambled_workers(&workers);
    begin();
    memcpy(made.end, half, sizeof made.end);
    answer((tf_response_options){.draft = true, .parallel = &parallel});
    memcpy(made.end, whole, sizeof made.end);
    ck_assert_mem_eq(
        answer((tf_response_options){.again = true, .parallel = &parallel}),
        end, sizeof(double) * (size_t)(made.mesh.axes * made.mesh.vertices));
    finish();
}

// The pairs that a draft has looked at are not all.
START_TEST(answers_after_a_draft_are_clear)
{
    static double half[3 * PROPOSAL_VERTICES], whole[3 * PROPOSAL_VERTICES],
        end[3 * PROPOSAL_VERTICES];
    make_wild(_i);
    begin();
    halve(whole);
    memcpy(half, made.end, sizeof half);
    answer(drafted);
    memcpy(made.end, whole, sizeof whole);
    for (int i = 0; i < 2; i++)
        memcpy(end, answer(again), sizeof end);
    ck_assert_msg(tangles_of(made.start, end) == 0, "seed %llu",
                  (unsigned long long)seed());
    finish();
    begin();
    memcpy(made.end, half, sizeof half);
    answer(drafted);
    memcpy(made.end, whole, sizeof whole);
    memcpy(end, answer(again), sizeof end);
    finish();
    ck_assert_int_eq(tangles_of(made.start, end), 0);
    expect_the_same_bits(half, whole, end);
}
END_TEST

// What meets in the second proposal alone is found, too.
START_TEST(pairs_that_no_draft_has_seen_are_found)
{
    proposal_begin(&made, 2);
    proposal_add_edge(&made, proposal_add_vertex(&made, -4, 0, 0),
                      proposal_add_vertex(&made, 4, 0, 0));
    proposal_add_vertex(&made, 0, 100, 0);
    begin();
    answer(drafted);
    made.end[5] -= 200;
    const double *end = answer(again);
    ck_assert_uint_eq(report.first_contacts, 1);
    ck_assert(end[5] > (end[1] + end[3]) / 2);
    finish();
}
END_TEST

/// Whether pairs were decided, as a search does, or measured, as those that are
/// kept are when they are looked at again.
static bool has_searched, has_measured;

static tf_status decide(void *context, const tf_arithmetic *arithmetic,
                        const tf_queries *queries, tf_verdict verdict[],
                        size_t *separated)
{
    has_searched |= !has_measured;
    return tf_vectorized.decide(context, arithmetic, queries, verdict,
                                separated);
}

static tf_status measure(void *context, const tf_arithmetic *arithmetic,
                         const tf_queries *queries, tf_verdict verdict[],
                         size_t *separated, double clearance[])
{
    has_measured = true;
    return tf_vectorized.measure(context, arithmetic, queries, verdict,
                                 separated, clearance);
}

/// Whether an answer begins with a search.
static bool searches_first(bool after_a_draft)
{
    static const tf_narrow_phase noting = {
        .name = "noting", .decide = decide, .measure = measure};
    begin();
    if (after_a_draft)
        answer(drafted);
    has_searched = has_measured = false;
    answer((tf_response_options){.again = true, .narrow_phase = &noting});
    ck_assert(has_measured);
    finish();
    return has_searched;
}

// It looks at them first, and does not search for them.
START_TEST(an_answer_after_a_draft_looks_at_its_pairs)
{
    generator random = generator_new(1);
    proposal_make(&random, BALLS, 3, SCATTERED, &made);
    ck_assert(searches_first(false));
    ck_assert(!searches_first(true));
}
END_TEST

// Answers without a draft -------------------------------------------------------

/// Without effect: the answer is that of a new resolver, to the last bit.
static void expect_no_effect(void)
{
    double *usual = answer_of_new_resolver((tf_response_options){0});
    ck_assert_mem_eq(answer(again), usual,
                     sizeof(double) *
                         (size_t)(made.mesh.axes * made.mesh.vertices));
    free(usual);
}

START_TEST(without_a_draft_nothing_is_kept)
{
    double whole[3 * PROPOSAL_VERTICES];
    make_wild(_i);
    begin();
    expect_no_effect();
    halve(whole);
    answer((tf_response_options){0});
    memcpy(made.end, whole, sizeof whole);
    expect_no_effect();
    finish();
}
END_TEST

// Another start, by an ulp in one coordinate; and another mass of one vertex.
START_TEST(drafts_of_other_steps_are_of_no_use)
{
    double whole[3 * PROPOSAL_VERTICES];
    make_wild(_i);
    begin();
    halve(whole);
    answer(drafted);
    memcpy(made.end, whole, sizeof whole);
    double x = made.start[1];
    made.start[1] = nextafter(x, INFINITY);
    if (tangles_of(made.start, made.start) == 0)
        expect_no_effect();
    made.start[1] = x;
    answer(drafted);
    made.inverse_mass[0] = made.inverse_mass[0] > 0 ? 0 : 1;
    expect_no_effect();
    finish();
}
END_TEST

/// All facets of one zone, or none of any: nothing is left out by the latter.
static const int *zones_of_all(bool one)
{
    static int zone[2][PROPOSAL_TRIANGLES + PROPOSAL_EDGES];
    for (int i = 0; i < PROPOSAL_TRIANGLES + PROPOSAL_EDGES; i++)
        zone[one][i] = one ? 0 : -1;
    return zone[one];
}

// With zones, without, and with others.
START_TEST(drafts_with_other_zones_are_of_no_use)
{
    double whole[3 * PROPOSAL_VERTICES];
    make_wild(_i);
    begin();
    halve(whole);
    for (int way = 0; way < 3; way++) {
        tf_response_options draft = drafted, own = again;
        draft.zone = way > 0 ? zones_of_all(true) : NULL;
        own.zone = way < 2 ? zones_of_all(false) : NULL;
        answer(draft);
        double *usual = answer_of_new_resolver((tf_response_options){0});
        ck_assert_mem_eq(answer(own), usual,
                         sizeof(double) *
                             (size_t)(made.mesh.axes * made.mesh.vertices));
        free(usual);
    }
    finish();
}
END_TEST

// A call that fails, or that does something else, leaves nothing either.
START_TEST(drafts_are_forgotten_by_other_calls)
{
    double whole[3 * PROPOSAL_VERTICES], end[3 * PROPOSAL_VERTICES];
    int halvings;
    make_wild(_i);
    begin();
    halve(whole);
    answer(drafted);
    memcpy(made.end, whole, sizeof whole);
    memcpy(end, whole, sizeof end);
    end[0] = NAN;
    ck_assert_int_eq(try(made.start, end, again), TF_NOT_FINITE);
    expect_no_effect();
    answer(drafted);
    memcpy(end, whole, sizeof end);
    ck_assert_int_eq(tf_step_limit(resolver, made.mesh.vertices, made.start,
                                   end, NULL, &halvings, NULL),
                     TF_OK);
    expect_no_effect();
    finish();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/drafts");
    TCase *tcase = tcase_create("drafts");
    int wild = (int)cases((long)PROPOSAL_SHAPES * PROPOSAL_WAYS);
    tcase_add_test(tcase, clear_steps_are_drafted_bit_for_bit);
    tcase_add_loop_test(tcase, drafts_are_of_impulses_and_zones, 0, wild);
    tcase_add_loop_test(tcase, answers_after_a_draft_are_clear, 0, wild);
    tcase_add_test(tcase, pairs_that_no_draft_has_seen_are_found);
    tcase_add_test(tcase, an_answer_after_a_draft_looks_at_its_pairs);
    tcase_add_loop_test(tcase, without_a_draft_nothing_is_kept, 0, wild);
    tcase_add_loop_test(tcase, drafts_of_other_steps_are_of_no_use, 0, wild);
    tcase_add_loop_test(tcase, drafts_with_other_zones_are_of_no_use, 0, wild);
    tcase_add_loop_test(tcase, drafts_are_forgotten_by_other_calls, 0, wild);
    suite_add_tcase(suite, tcase);
    return suite;
}
