#include "support/zoned_steps.h"

#include "base/describe.h"
#include "response/resolve.h"
#include "support/near_oracle.h"
#include "support/proposals.h"
#include "support/zoned_facets.h"
#include "untangle/tangled_zones.h"

#include <stdio.h>
#include <string.h>

enum {
    ALL = PROPOSAL_SHAPES * PROPOSAL_WAYS,
    SIZES = 3,
    FEW_VERTICES = 30,
    MOST_FACETS = PROPOSAL_TRIANGLES + PROPOSAL_EDGES
};

/// What is resolved, step after step.
static struct {
    proposal made;
    double clear[3 * PROPOSAL_VERTICES]; ///< where it was without tangles
    int zone[MOST_FACETS];
    zoned_facets facets;
    bool weighed, weak;
    tf_surface *surface;
    tf_resolver *resolver;
    tangle_judge *judge;
} own;

static int numbers(void)
{
    return own.made.mesh.axes * own.made.mesh.vertices;
}

// Tangled starts --------------------------------------------------------------

static void throw_vertex(generator *random, double x[], int vertex,
                         double reach)
{
    int axes = own.made.mesh.axes;
    for (int k = 0; k < axes; k++)
        x[axes * vertex + k] += uniform(random, -reach, reach);
}

static double distance_along_axes(const double *a, const double *b)
{
    double sum = 0;
    for (int k = 0; k < own.made.mesh.axes; k++)
        sum += a[k] > b[k] ? a[k] - b[k] : b[k] - a[k];
    return sum;
}

/// Throws the vertices near one of them.
static void throw_neighbors(generator *random, double x[], double reach)
{
    int axes = own.made.mesh.axes, vertices = own.made.mesh.vertices;
    double center[3] = {0}, radius = own.made.unit * uniform(random, 0.5, 3);
    memcpy(center, x + axes * below(random, vertices),
           sizeof *center * (size_t)axes);
    for (int v = 0; v < vertices; v++)
        if (distance_along_axes(x + axes * v, center) < radius)
            throw_vertex(random, x, v, reach);
}

static void tangle_start(generator *random)
{
    double *x = own.made.start, part = uniform(random, 0.1, 1);
    int way = below(random, 4);
    memcpy(own.clear, x, sizeof own.clear);
    for (int i = 0; i < numbers() && way == 0; i++)
        x[i] += part * (own.made.end[i] - x[i]);
    for (int i = 1 + below(random, 4); i > 0 && way == 1; i--)
        throw_vertex(random, x, below(random, own.made.mesh.vertices),
                     3 * own.made.unit);
    for (int i = 1 + below(random, 3); i > 0 && way > 1; i--)
        throw_neighbors(random, x, 1.5 * own.made.unit);
}

/// Proposes that all moves a little, or a part of it, or that it goes home.
static void propose_end(generator *random)
{
    double *end = own.made.end, reach = own.made.unit * uniform(random, 0, 1.5);
    memcpy(end, own.made.start, sizeof own.made.end);
    int way = below(random, 4);
    for (int v = 0; v < own.made.mesh.vertices && way < 2; v++)
        throw_vertex(random, end, v, reach);
    if (way == 2)
        throw_neighbors(random, end, 4 * reach);
    if (way == 3)
        memcpy(end, own.clear, sizeof own.made.end);
}

static tf_response_options random_options(generator *random)
{
    return (tf_response_options){
        .size = sizeof(tf_response_options),
        .impulse_rounds = below(random, 4),
        .zone_rounds = below(random, 2) ? -1 : below(random, 4),
        .rigid = below(random, 3) == 0,
        .separation = below(random, 2) ? -1 : 0,
        .restitution = below(random, 3) ? 0 : uniform(random, 0, 1),
        .friction = below(random, 3) ? 0 : uniform(random, 0, 2),
        .thickness =
            below(random, 4) ? 0 : own.made.unit * uniform(random, 0, 0.3),
        .check_start = true,
        .zone = own.weak ? NULL : own.zone,
    };
}

// The planted rule ------------------------------------------------------------

static bool is_wanted(void *context, const tf_element_pair *pair)
{
    (void)context;
    int first = pair->kind == TF_EDGE_EDGE ? 2 : 1;
    int second = pair->kind == TF_POINT_TRIANGLE ? 3 : 2;
    return !some_zones_meet(&own.facets, first, pair->vertex, second,
                            pair->vertex + first);
}

// Judging ---------------------------------------------------------------------

static const char *told(const char *what, const char *more)
{
    static char text[300];
    snprintf(text, sizeof text, "%s: %s", what, more);
    return text;
}

/// How many vertices the two elements of a tangle have.
static void find_corners(const tangle *found, int *first, int *second)
{
    bool edges = found->kind == EDGES_MEET;
    *first = found->kind == EDGE_PIERCES_TRIANGLE || edges ? 2 : 1;
    *second = edges || found->kind == POINT_IN_EDGE ? 2 : 3;
}

static bool is_kept(const tangle *found)
{
    int first, second;
    find_corners(found, &first, &second);
    return !zones_leave_out(&own.facets, first, found->vertex, second,
                            found->vertex + first);
}

/// Whether a tangle must be in a zone.
static bool is_of_facets(const tangle *found)
{
    int first, second;
    find_corners(found, &first, &second);
    return found->kind != POINT_IN_EDGE &&
           !is_bare(&own.facets, first, found->vertex) &&
           !is_bare(&own.facets, second, found->vertex + first);
}

/// Whether two facets of one zone were not in one zone before, or a facet of
/// one was in none.
static bool have_grown(const int before[])
{
    int was[MOST_FACETS]; // of each zone: what it was before; -1: not seen yet
    for (int z = 0; z < own.facets.facets; z++)
        was[z] = -1;
    for (int f = 0; f < own.facets.facets; f++) {
        int zone = own.zone[f];
        if (zone < 0)
            continue;
        if (before[f] < 0 || (was[zone] >= 0 && was[zone] != before[f]))
            return true;
        was[zone] = before[f];
    }
    return false;
}

/// Finds the zones of the start, with that many rings.
static bool find_zones(int rings, zoned_counts *counts)
{
    int zones;
    const tf_pair_filter planted = {.wanted = is_wanted};
    tf_surface_set_filter(own.surface, NULL, NULL);
    if (tf_surface_zones(own.surface, own.made.mesh.vertices, own.made.start,
                         rings, NULL, own.zone, &zones, NULL, NULL) != TF_OK)
        return false;
    own.facets = zoned_facets_of(own.surface, own.zone);
    counts->zones += zones;
    return !own.weak ||
           tf_surface_set_filter(own.surface, &planted, NULL) == TF_OK;
}

/// Judges the start.  `*tangled`: whether it is, `*outside`: by pairs that are
/// kept, too, which may only be those that no zone can have.
static const char *start_fault(bool *tangled, bool *outside,
                               zoned_counts *counts)
{
    int count = tangle_count(own.judge, own.made.start);
    *tangled = count > 0;
    *outside = false;
    for (int i = 0; i < count; i++) {
        const tangle *found = &tangles(own.judge)[i];
        bool kept = is_kept(found);
        *outside = *outside || kept;
        counts->left_out += !kept;
        if (kept && is_of_facets(found))
            return told("in no zone", tangle_text(found));
    }
    return NULL;
}

static const char *outside_fault(const char *when, int count)
{
    for (int i = 0; i < count; i++)
        if (is_outside_of_zones(&own.facets, &tangles(own.judge)[i]))
            return told(when, tangle_text(&tangles(own.judge)[i]));
    return NULL;
}

static const char *way_fault(generator *random, zoned_counts *counts)
{
    if (own.made.mesh.vertices > FEW_VERTICES || below(random, 4) > 0)
        return NULL;
    counts->exact++;
    return outside_fault(
        "on the way",
        tangle_count_in_step(own.judge, own.made.start, own.made.end));
}

/// Pairs that are kept and end nearer than the thickness, but did not start so.
static const char *thickness_fault(double length)
{
    size_t count;
    if (!(length > 0) || own.weighed || own.weak ||
        own.made.mesh.vertices > FEW_VERTICES)
        return NULL;
    const near_oracle_pair *pair =
        near_oracle(own.surface, own.made.end, own.made.start, length, &count);
    for (size_t i = 0; i < count; i++) {
        int first = pair[i].kind == TF_EDGE_EDGE ? 2 : 1;
        int second = pair[i].kind == TF_POINT_TRIANGLE ? 3 : 2;
        if (!zones_leave_out(&own.facets, first, pair[i].vertex, second,
                             pair[i].vertex + first))
            return "a pair outside of zones is too near";
    }
    return NULL;
}

/// Finds the zones of a start.  If it is the end of a step, and there are no
/// rings now, they must not have grown, unless scripted vertices may have met.
static const char *zones_fault(generator *random, bool first,
                               zoned_counts *counts)
{
    int before[MOST_FACETS], rings = below(random, 3) ? 0 : below(random, 3);
    memcpy(before, own.zone, sizeof before);
    if (!find_zones(rings, counts))
        return "no zones";
    bool may_grow = first || rings > 0 || own.weighed || own.weak;
    return !may_grow && have_grown(before) ? "a zone has grown" : NULL;
}

static const char *step_fault(generator *random, bool first,
                              zoned_counts *counts, bool *ended)
{
    bool tangled = false, outside = false;
    const tf_response_report *report;
    tf_error error;
    char text[200];
    const char *fault = zones_fault(random, first, counts);
    if (!fault)
        fault = start_fault(&tangled, &outside, counts);
    *ended = fault || !tangled;
    if (*ended)
        return fault;
    propose_end(random);
    tf_response_options options = random_options(random);
    tf_status status = tf_step_resolve(
        own.resolver, own.made.mesh.vertices, own.made.start, own.made.end,
        own.weighed ? own.made.inverse_mass : NULL, &options, &report, &error);
    *ended = status == TF_START_NOT_CLEAR;
    counts->refused += *ended;
    if (*ended)
        return outside || own.weak
                   ? NULL
                   : "a start is refused that is clear but in zones";
    tf_describe(&error, text, sizeof text);
    if (status != TF_OK)
        return told("resolve", text);
    if (outside && !own.weak)
        return "a start is not refused that is tangled outside of zones";
    counts->steps++;
    counts->pairs += count_pairs_kept_apart(&own.facets);
    counts->met += report->first_contacts > 0;
    counts->rescued += report->rounds[TF_FAILSAFE] > 0;
    fault = outside_fault("at the end", tangle_count(own.judge, own.made.end));
    if (!fault)
        fault = way_fault(random, counts);
    return fault ? fault : thickness_fault(options.thickness);
}

// Runs ------------------------------------------------------------------------

static bool begin(generator *random, long number, bool weak)
{
    proposal_make(random, (proposal_shape)(number % PROPOSAL_SHAPES),
                  1 + (int)(number / ALL % SIZES),
                  (proposal_way)(number / PROPOSAL_SHAPES % PROPOSAL_WAYS),
                  &own.made);
    own.weighed = below(random, 3) == 0;
    own.weak = weak;
    if (own.weighed)
        proposal_weigh(random, &own.made);
    tangle_start(random);
    own.judge = tangle_judge_new(&own.made.mesh);
    tangle_judge_script(own.judge, own.weighed ? own.made.inverse_mass : NULL);
    own.surface = NULL;
    own.resolver = NULL;
    return tf_surface_create(&own.made.mesh, &own.surface, NULL) == TF_OK &&
           tf_resolver_create(own.surface, &own.resolver) == TF_OK;
}

static void end(void)
{
    tf_resolver_free(own.resolver);
    tf_surface_free(own.surface);
    tangle_judge_free(own.judge);
}

const char *zoned_fault(long number, bool weak, zoned_counts *counts)
{
    static char text[500];
    generator random = generator_new((uint64_t)number);
    const char *fault = begin(&random, number, weak) ? NULL : "no resolver";
    bool ended = false;
    int steps = 1 + below(&random, 3);
    for (int i = 0; i < steps && !fault && !ended; i++) {
        fault = step_fault(&random, i == 0, counts, &ended);
        memcpy(own.made.start, own.made.end, sizeof own.made.start);
    }
    end();
    if (!fault)
        return NULL;
    counts->faulty++;
    snprintf(text, sizeof text, "run %ld of seed %llu, %s: %s", number,
             (unsigned long long)seed(),
             proposal_shapes[number % PROPOSAL_SHAPES], fault);
    return text;
}

void zoned_counts_print(const zoned_counts *counts)
{
    printf("%ld steps, %ld starts refused, %ld zones, %ld "
           "intersections left out, %ld pairs judged, %ld steps with "
           "contacts, %ld by the failsafe, %ld judged on the way, %ld "
           "faulty\n",
           counts->steps, counts->refused, counts->zones, counts->left_out,
           counts->pairs, counts->met, counts->rescued, counts->exact,
           counts->faulty);
}
