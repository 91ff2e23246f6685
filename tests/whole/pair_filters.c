// Steps of filtered surfaces, resolved and limited, judged by what shares no
// code with detection: no pair that is kept meets, at the end or on the way.
#include "fast/vectorized.h"
#include "response/limit.h"
#include "response/resolve.h"
#include "support/pair_rules.h"
#include "support/proposals.h"
#include "support/scrambled_workers.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/tangle.h"

#include <stdio.h>
#include <string.h>

enum {
    STEPS = 3,
    FEW_VERTICES = 30
};

static proposal made;
static pair_rule rule;

/// What resolves and judges.
typedef struct scene {
    tf_surface *surface;
    tf_resolver *resolver;
    tangle_judge *judge;
} scene;

/// How often what happened.
static struct {
    int steps, met, rescued, exact;
    int tangled; ///< steps that start with tangles of pairs that are left out
} counts;

static scene scene_new(void)
{
    scene s = {surface_of(&made.mesh), NULL, tangle_judge_new(&made.mesh)};
    ck_assert_int_eq(tf_surface_set_filter(s.surface, &rule.filter, NULL),
                     TF_OK);
    ck_assert_int_eq(tf_resolver_create(s.surface, &s.resolver), TF_OK);
    return s;
}

static void scene_free(scene *s)
{
    tangle_judge_free(s->judge);
    tf_resolver_free(s->resolver);
    tf_surface_free(s->surface);
}

static int count_kept(const scene *s, int count)
{
    return pair_rule_count_tangles(&rule, count, tangles(s->judge));
}

static void expect_clear(scene *s, bool exactly)
{
    ck_assert_int_eq(count_kept(s, tangle_count(s->judge, made.end)), 0);
    if (exactly)
        ck_assert_int_eq(
            count_kept(s, tangle_count_in_step(s->judge, made.start, made.end)),
            0);
    counts.exact += exactly;
}

/// Proposes a next step: from where the vertices are, by a few edge lengths.
static void go_on(generator *random)
{
    double reach = made.unit * uniform(random, 0, 3);
    int numbers = made.mesh.axes * made.mesh.vertices;
    memcpy(made.start, made.end, sizeof *made.end * (size_t)numbers);
    for (int i = 0; i < numbers; i++)
        made.end[i] += uniform(random, -reach, reach);
}

static int workers = 3;

static tf_response_options random_options(generator *random,
                                          const tf_parallel *parallel)
{
    static const tf_narrow_phase *const phases[] = {NULL, &tf_reference,
                                                    &tf_vectorized};
    return (tf_response_options){.narrow_phase = phases[below(random, 3)],
                                 .impulse_rounds = below(random, 3),
                                 .zone_rounds = below(random, 3) ? -1 : 2,
                                 .rigid = below(random, 3) == 0,
                                 .check_start = true,
                                 .parallel =
                                     below(random, 2) ? parallel : NULL};
}

static void resolve(scene *s, generator *random)
{
    tf_parallel parallel = scrambled_workers(&workers);
    tf_response_options options = random_options(random, &parallel);
    const tf_response_report *report;
    tf_error error;
    ck_assert_int_eq(tf_step_resolve(s->resolver, made.mesh.vertices,
                                     made.start, made.end, made.inverse_mass,
                                     &options, &report, &error),
                     TF_OK);
    counts.steps++;
    counts.met += report->first_contacts > 0;
    counts.rescued += report->rounds[TF_FAILSAFE] > 0;
    tangle_judge_script(s->judge, made.inverse_mass);
    expect_clear(s,
                 made.mesh.vertices <= FEW_VERTICES && below(random, 4) == 0);
}

static void shorten(scene *s)
{
    tf_response_options options = {.check_start = true};
    int halvings;
    ck_assert_int_eq(tf_step_limit(s->resolver, made.mesh.vertices, made.start,
                                   made.end, &options, &halvings, NULL),
                     TF_OK);
    expect_clear(s, false);
}

/// A proposal of a filtered surface, and more steps from where it ends: each
/// end is a good start, though pairs that are left out may be tangled by then.
static void try_proposal(generator *random, int number)
{
    proposal_make(random, (proposal_shape)(number % PROPOSAL_SHAPES),
                  1 + below(random, 3),
                  (proposal_way)(number / PROPOSAL_SHAPES % PROPOSAL_WAYS),
                  &made);
    proposal_weigh(random, &made);
    pair_rule_make(random, made.mesh.axes, made.mesh.vertices, made.start,
                   &rule);
    scene s = scene_new();
    bool starts_clear = tangle_count(s.judge, made.start) == 0;
    for (int i = 0; i < STEPS && starts_clear; i++) {
        counts.tangled += tangle_count(s.judge, made.start) > 0;
        if (i == 0 && number % 3 == 0)
            shorten(&s);
        else
            resolve(&s, random);
        go_on(random);
    }
    scene_free(&s);
}

START_TEST(pairs_that_are_kept_never_meet)
{
    generator random = generator_new(1);
    int tries = (int)cases_at_least(24, 120);
    for (int i = 0; i < tries; i++)
        try_proposal(&random, i);
    printf("%d steps: %d with contacts, %d by the failsafe, %d from tangled "
           "starts, %d judged on the way\n",
           counts.steps, counts.met, counts.rescued, counts.tangled,
           counts.exact);
    ck_assert_int_ge(counts.steps, 2 * tries);
    ck_assert_int_ge(2 * counts.met, tries);
    ck_assert_int_ge(5 * counts.rescued, tries);
    ck_assert_int_ge(5 * counts.tangled, tries);
}
END_TEST

// A start that is not clear ---------------------------------------------------

static const int corner[] = {0, 1, 2, 3, 4, 5};
static const double tangled[] = {0, 0, 0,  4, 0, 0, 0, 4, 0,
                                 1, 1, -1, 1, 1, 1, 9, 9, 1};
static const tf_mesh two = {
    .axes = 3, .vertices = 6, .triangles = 2, .triangle = corner};

static tf_status resolve_tangled(const int group[], tf_error *error)
{
    double end[18];
    tf_surface *surface = surface_of(&two);
    tf_resolver *resolver;
    tf_pair_filter filter = {.vertices = 6, .group = group};
    tf_response_options options = {.check_start = true};
    ck_assert_int_eq(tf_surface_set_filter(surface, &filter, NULL), TF_OK);
    ck_assert_int_eq(tf_resolver_create(surface, &resolver), TF_OK);
    memcpy(end, tangled, sizeof end);
    tf_status status =
        tf_step_resolve(resolver, 6, tangled, end, NULL, &options, NULL, error);
    tf_resolver_free(resolver);
    tf_surface_free(surface);
    return status;
}

START_TEST(only_pairs_that_are_kept_must_start_clear)
{
    static const int apart[] = {1, 1, 1, 2, 2, 2};
    static const int together[] = {1, 1, 1, 1, 1, 1};
    tf_error error;
    ck_assert_int_eq(resolve_tangled(apart, &error), TF_START_NOT_CLEAR);
    ck_assert_int_eq(error.subject, TF_EDGE_TRIANGLE_PAIR);
    ck_assert_int_eq(resolve_tangled(together, &error), TF_OK);
}
END_TEST

// Rigid bodies ----------------------------------------------------------------

/// Two sheets that fall through each other are free to if they are of one group,
/// and are stopped if each has a group of its own.
START_TEST(sheets_of_one_group_pass_through_each_other)
{
    proposal_begin(&made, 3);
    int lower = proposal_add_sheet(&made, 3, 0);
    int upper = proposal_add_sheet(&made, 3, 1);
    rule = (pair_rule){0};
    for (int v = 0; v < made.mesh.vertices; v++) {
        made.end[3 * v + 2] = v < upper ? 1 : -1;
        rule.group[v] = _i && v >= upper ? 2 : 1;
    }
    ck_assert_int_eq(lower, 0);
    rule.filter.vertices = made.mesh.vertices;
    rule.filter.group = rule.group;
    scene s = scene_new();
    const tf_response_report *report;
    ck_assert_int_eq(tf_step_resolve(s.resolver, made.mesh.vertices, made.start,
                                     made.end, NULL, NULL, &report, NULL),
                     TF_OK);
    ck_assert_int_eq(report->moved > 0, _i);
    ck_assert_int_eq(report->first_contacts > 0, _i);
    ck_assert_int_eq(report->statistics.candidates > 0, _i);
    scene_free(&s);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/pair_filters");
    TCase *c = tcase_create("pair filters");
    tcase_add_test(c, pairs_that_are_kept_never_meet);
    tcase_add_test(c, only_pairs_that_are_kept_must_start_clear);
    tcase_add_loop_test(c, sheets_of_one_group_pass_through_each_other, 0, 2);
    suite_add_tcase(suite, c);
    return suite;
}
