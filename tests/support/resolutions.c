#include "support/resolutions.h"

#include "base/contract.h"
#include "base/describe.h"
#include "response/conjugate_residuals.h"
#include "response/gauss_seidel.h"
#include "response/minres.h"
#include "response/normal_residuals.h"
#include "support/answers.h"
#include "support/near_oracle.h"
#include "support/tangle.h"

#include <stdio.h>
#include <string.h>

// What is wrong ---------------------------------------------------------------

static bool differ(const proposal *made, const double a[], const double b[],
                   int vertex)
{
    int axes = made->mesh.axes;
    for (int i = axes * vertex; i < axes * (vertex + 1); i++)
        if (a[i] != b[i])
            return true;
    return false;
}

/// What the report says of the vertices that were moved, against the ends.
static const char *report_fault(const proposal *made, bool weighed,
                                const double proposed[],
                                const tf_response_options *options,
                                const tf_response_report *report)
{
    int moved = 0, held = 0;
    for (int v = 0; v < made->mesh.vertices; v++) {
        bool is_moved = differ(made, proposed, made->end, v);
        moved += is_moved;
        held += is_moved && weighed && made->inverse_mass[v] == 0;
    }
    if (moved != report->moved)
        return "the report counts other vertices that were moved";
    if (held != report->held)
        return "the report counts other scripted vertices held back";
    if ((held > 0) != (report->followed < 1))
        return "scripted vertices held back, but all the way; or vice versa";
    if (report->first_contacts + report->first_near == 0 && moved > 0)
        return "a clear step was changed";
    int parts = options && options->substeps > 1 ? options->substeps : 1;
    if (report->rounds[TF_FAILSAFE] >= parts * made->mesh.vertices)
        return "as many rounds of the failsafe as vertices, or more";
    return NULL;
}

static const char *tangle_fault(const char *when, const tangle_judge *judge)
{
    static char text[200];
    snprintf(text, sizeof text, "%s: %s", when, tangle_text(tangles(judge)));
    return text;
}

static bool is_scripted(const proposal *made, const near_oracle_pair *pair)
{
    for (int i = 0; i < 4 && pair->vertex[i] >= 0; i++)
        if (made->inverse_mass[pair->vertex[i]] > 0)
            return false;
    return true;
}

/// Pairs that end nearer than the thickness, but did not start so, and have a
/// vertex that is not scripted.
static const char *thickness_fault(const tf_surface *surface,
                                   const proposal *made, bool weighed,
                                   const tf_response_options *options)
{
    static char text[200];
    double length = options ? options->thickness : 0;
    size_t count = 0;
    const near_oracle_pair *pair =
        length > 0
            ? near_oracle(surface, made->end, made->start, length, &count)
            : NULL;
    for (size_t i = 0; i < count; i++) {
        if (weighed && is_scripted(made, &pair[i]))
            continue;
        const int *vertex = pair[i].vertex;
        snprintf(text, sizeof text, "nearer than %a, kind %d: %d %d %d %d",
                 length, pair[i].kind, vertex[0], vertex[1], vertex[2],
                 vertex[3]);
        return text;
    }
    return NULL;
}

static const char *end_fault(tangle_judge *judge, const proposal *made,
                             bool exactly)
{
    if (tangle_count(judge, made->end) > 0)
        return tangle_fault("at the end", judge);
    if (exactly && tangle_count_in_step(judge, made->start, made->end) > 0)
        return tangle_fault("on the way", judge);
    return NULL;
}

static const char *status_fault(const tf_error *error)
{
    static char text[200];
    tf_describe(error, text, sizeof text);
    return text;
}

static double motion[3 * PROPOSAL_VERTICES];

const double *resolution_motion(void)
{
    return motion;
}

/// Drafts another step from the same start: half of the one that is proposed.
static tf_status draft(tf_resolver *resolver, const proposal *made,
                       bool weighed, const tf_response_options *options)
{
    static double half[3 * PROPOSAL_VERTICES];
    tf_response_options own = *options;
    own.draft = true;
    own.substeps = 0;
    for (int i = 0; i < made->mesh.axes * made->mesh.vertices; i++)
        half[i] = (made->start[i] + made->end[i]) / 2;
    return tf_step_resolve(resolver, made->mesh.vertices, made->start, half,
                           weighed ? made->inverse_mass : NULL, &own, NULL,
                           NULL);
}

static const char *judged_fault(tf_surface *surface, tf_resolver *resolver,
                                tangle_judge *judge, proposal *made,
                                bool weighed, bool exactly,
                                const tf_response_options *options,
                                tf_response_report *report)
{
    static double proposed[3 * PROPOSAL_VERTICES];
    tf_error error;
    const tf_response_report *lent;
    memcpy(proposed, made->end, sizeof proposed);
    if (options && options->again &&
        draft(resolver, made, weighed, options) != TF_OK)
        return "a draft fails";
    tf_status status = tf_step_resolve(
        resolver, made->mesh.vertices, made->start, made->end,
        weighed ? made->inverse_mass : NULL, options, &lent, &error);
    if (status != TF_OK)
        return status_fault(&error);
    *report = *lent;
    memcpy(motion, tf_resolver_unpushed(resolver),
           sizeof *motion * (size_t)(made->mesh.axes * made->mesh.vertices));
    const answered_step step = {
        made->mesh.axes, made->mesh.vertices,
        made->start,     proposed,
        made->end,       weighed ? made->inverse_mass : NULL,
        options,         report};
    const char *fault = end_fault(judge, made, exactly);
    if (!fault)
        fault = thickness_fault(surface, made, weighed, options);
    if (!fault)
        fault = report_fault(made, weighed, proposed, step.options, report);
    return fault ? fault : answers_fault(resolver, &step, NULL);
}

const char *resolution_fault(proposal *made, bool weighed, bool exactly,
                             const tf_response_options *options,
                             tf_response_report *report)
{
    tangle_judge *judge = tangle_judge_new(&made->mesh);
    tangle_judge_script(judge, weighed ? made->inverse_mass : NULL);
    tf_surface *surface = NULL;
    tf_resolver *resolver = NULL;
    const char *fault = "no resolver";
    if (tf_surface_create(&made->mesh, &surface, NULL) == TF_OK &&
        tf_resolver_create(surface, &resolver) == TF_OK)
        fault = judged_fault(surface, resolver, judge, made, weighed, exactly,
                             options, report);
    tf_resolver_free(resolver);
    tf_surface_free(surface);
    tangle_judge_free(judge);
    return fault;
}

// Numbers ---------------------------------------------------------------------

/// Of each vertex, some of which have none.
static const double *random_friction(generator *random)
{
    static double own[PROPOSAL_VERTICES];
    for (int v = 0; v < PROPOSAL_VERTICES; v++)
        own[v] = below(random, 4) ? uniform(random, 0, 2) : 0;
    return own;
}

static tf_response_options random_options(generator *random, double unit)
{
    static const tf_zone_solver *const solvers[] = {
        NULL, &tf_gauss_seidel, &tf_conjugate_residuals, &tf_minres,
        &tf_normal_residuals};
    tf_response_options options = {.size = sizeof options,
                                   .solver = solvers[below(random, 5)]};
    options.impulse_rounds = below(random, 2) ? 0 : below(random, 4);
    options.zone_rounds = below(random, 3) ? 0 : below(random, 5) - 1;
    options.sweeps = below(random, 2) ? 0 : 1 + below(random, 30);
    options.rigid = below(random, 3) == 0;
    options.separation = uniform(random, -0.1, 0.1) * below(random, 2);
    options.restitution = below(random, 3) ? 0 : uniform(random, 0, 1);
    options.friction = below(random, 3) ? 0 : uniform(random, 0, 2);
    options.check_start = below(random, 2);
    options.size = sizeof options;
    options.restitution_threshold =
        below(random, 2) ? 0 : uniform(random, 0, 1);
    options.vertex_friction = below(random, 3) ? NULL : random_friction(random);
    options.substeps = below(random, 3) ? 0 : below(random, 6);
    options.thickness = below(random, 2) ? 0 : unit * uniform(random, 0, 0.3);
    options.again = below(random, 3) == 0;
    return options;
}

static bool starts_clear(const proposal *made)
{
    tangle_judge *judge = tangle_judge_new(&made->mesh);
    bool clear = tangle_count(judge, made->start) == 0;
    tangle_judge_free(judge);
    return clear;
}

static void count(const tf_response_report *report, resolution_counts *counts)
{
    int rounds = report->rounds[TF_FAILSAFE];
    counts->met += report->first_contacts > 0;
    counts->thick += report->near > 0;
    counts->rescued += rounds > 0;
    counts->held += report->held > 0;
    counts->shortened += report->held > 0 && report->followed > 0;
    counts->rested += report->resting > 0;
    counts->rounds = rounds > counts->rounds ? rounds : counts->rounds;
}

void resolution_counts_print(const resolution_counts *counts)
{
    printf("%ld proposals: %ld with contacts, %ld with near pairs, %ld by the "
           "failsafe, %ld held "
           "back, %ld of these a part of the way, %ld put to rest, %ld judged "
           "on the way, %d rounds at most\n",
           counts->tries, counts->met, counts->thick, counts->rescued,
           counts->held, counts->shortened, counts->rested, counts->exact,
           counts->rounds);
}

/// What is being tried, for the handler.
static long tried;

static void show_tried(const char *file, int line, const char *condition)
{
    fprintf(stderr, "%s:%d: broken contract: %s\nproposal %ld of seed %llu\n",
            file, line, condition, tried, (unsigned long long)seed());
}

enum {
    ALL = PROPOSAL_SHAPES * PROPOSAL_WAYS,
    SIZES = 4,
    FEW_VERTICES = 30
};

/// Proposes a next step, from where the last one has ended.
static void go_on(generator *random, proposal *made)
{
    double reach = made->unit * uniform(random, 0, 2);
    int numbers = made->mesh.axes * made->mesh.vertices;
    memcpy(made->start, made->end, sizeof *made->end * (size_t)numbers);
    for (int i = 0; i < numbers; i++)
        made->end[i] += uniform(random, -reach, reach);
}

const char *numbered_fault(long number, resolution_counts *counts)
{
    static proposal made;
    static char text[400];
    generator random = generator_new((uint64_t)number);
    proposal_shape shape = (proposal_shape)(number % PROPOSAL_SHAPES);
    proposal_way way = (proposal_way)(number / PROPOSAL_SHAPES % PROPOSAL_WAYS);
    int size = 1 + (int)(number / ALL % SIZES);
    proposal_make(&random, shape, size, way, &made);
    proposal_weigh(&random, &made);
    if (!starts_clear(&made))
        return NULL;
    tried = number;
    tf_contract_set_handler(show_tried);
    bool weighed = below(&random, 2);
    bool exactly = made.mesh.vertices <= FEW_VERTICES && below(&random, 4) == 0;
    const char *fault = NULL;
    for (int steps = 1 + below(&random, 2); steps > 0 && !fault; steps--) {
        tf_response_options options = random_options(&random, made.unit);
        tf_response_report report = {0};
        bool straight = options.substeps <= 1;
        fault = resolution_fault(&made, weighed, exactly && straight, &options,
                                 &report);
        counts->tries++;
        counts->exact += exactly && straight;
        count(&report, counts);
        go_on(&random, &made);
    }
    if (!fault)
        return NULL;
    snprintf(text, sizeof text, "proposal %ld of seed %llu, %s %s: %s", number,
             (unsigned long long)seed(), proposal_shapes[shape],
             proposal_ways[way], fault);
    return text;
}
