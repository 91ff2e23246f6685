//: Include what resolving needs
#include "response/resolve.h"

#include "base/require.h"
#include "fast/estimate.h"
#include "fast/vectorized.h"
#include "response/gauss_seidel.h"
#include "response/levels.h"
#include "response/start.h"

#include <math.h>
#include <string.h>

//: Check the options
static bool are_good(const tf_response_options *options)
{
    return isfinite(options->separation) && options->restitution >= 0 &&
           options->restitution <= 1 && options->friction >= 0 &&
           isfinite(options->friction) && options->impulse_rounds >= 0 &&
           options->sweeps >= 0;
}

//: Check the masses
static tf_status check_masses(const tf_step *step, tf_flaw *flaw)
{
    for (int v = 0; v < step->vertices; v++)
        if (!(step->inverse_mass[v] >= 0) || !isfinite(step->inverse_mass[v])) {
            *flaw = (tf_flaw){TF_VERTEX, v, v};
            return TF_BAD_MASS;
        }
    return TF_OK;
}

//: Find the mean edge
static double mean_edge(const tf_surface *surface, const tf_step *step)
{
    int count;
    const int *edge = tf_surface_edges(surface, &count);
    double sum = 0;
    for (int i = 0; i < count; i++, edge += 2) {
        tf_vector from = tf_step_position(step, edge[0], step->start);
        tf_vector to = tf_step_position(step, edge[1], step->start);
        sum += tf_vector_length(tf_vector_difference(to, from));
    }
    double mean = count > 0 ? sum / count : 0;
    return isfinite(mean) ? mean : 0;
}

//: Choose what is left to choose
enum {
    USUAL_ROUNDS = 20,
    USUAL_SWEEPS = 30
};

static const double usual_separation = 0.05; // of the mean edge

static void choose(tf_resolution *r)
{
    tf_response_options *options = &r->options;
    if (!options->solver)
        options->solver = &tf_gauss_seidel;
    if (options->zone_rounds == 0)
        options->zone_rounds = USUAL_ROUNDS;
    if (options->sweeps == 0)
        options->sweeps = USUAL_SWEEPS;
    if (options->separation == 0)
        options->separation =
            usual_separation * mean_edge(r->resolver->surface, &r->step);
    r->rule.separation = options->separation;
    r->rule.restitution = options->restitution;
}

//: Ready a step
static const double *all_ones(tf_resolver *resolver, int vertices)
{
    if (!tf_buffer_reserve(&resolver->ones, (size_t)vertices, sizeof(double)))
        return NULL;
    double *one = resolver->ones.data;
    for (int v = 0; v < vertices; v++)
        one[v] = 1;
    return one;
}

static bool ready(tf_resolution *r)
{
    tf_resolver *resolver = r->resolver;
    size_t vertices = (size_t)r->step.vertices;
    size_t bytes = sizeof(double) * (size_t)r->step.axes * vertices;
    if (!tf_buffer_reserve(&resolver->end, bytes, 1))
        return false;
    r->step.end = memcpy(resolver->end.data, r->step.proposed, bytes);
    r->motion.end = r->step.end;
    r->search = (tf_contact_search){.surface = resolver->surface,
                                    .motion = &r->motion,
                                    .narrow_phase = r->options.narrow_phase,
                                    .estimate = tf_contact_estimate,
                                    .parallel = r->options.parallel};
    return true;
}

//: Detect what the proposal does
static tf_status begin(tf_resolution *r, tf_obstacle *obstacle)
{
    tf_status status = TF_OK;
    if (r->options.check_start)
        status = tf_start_check(r->resolver->surface, &r->motion,
                                r->options.parallel, obstacle);
    if (status == TF_OK)
        status = tf_pair_cache_build(&r->resolver->pairs, &r->search,
                                     &r->contacts, &obstacle->flaw);
    if (status == TF_OK)
        status = tf_start_check_contacts(&r->motion, r->step.axes, &r->contacts,
                                         obstacle);
    r->report.first_contacts = r->report.contacts = r->contacts.count;
    r->report.statistics = r->contacts.statistics;
    return status;
}

//: Sum up energies
/// The kinetic energy of the vertices that are not scripted.
static double energy(const tf_step *step, const double end[])
{
    double sum = 0;
    for (int v = 0; v < step->vertices; v++) {
        if (!(step->inverse_mass[v] > 0))
            continue;
        tf_vector d = tf_step_displacement(step, v, end);
        sum += tf_vector_dot(d, d) / step->inverse_mass[v];
    }
    return sum / 2;
}

//: Write the report
static void count_moved(const tf_step *step, tf_response_report *report)
{
    size_t bytes = sizeof(double) * (size_t)step->axes;
    for (int v = 0; v < step->vertices; v++) {
        ptrdiff_t place = (ptrdiff_t)step->axes * v;
        bool moved =
            memcmp(step->end + place, step->proposed + place, bytes) != 0;
        report->moved += moved;
        report->held += moved && !(step->inverse_mass[v] > 0);
    }
}

static void write_report(tf_resolution *r)
{
    tf_response_report *report = &r->report;
    report->energy_before = energy(&r->step, r->step.proposed);
    report->energy_after = energy(&r->step, r->step.end);
    count_moved(&r->step, report);
    report->constraints = report->rounds[TF_ZONES] > 0
                              ? (size_t)r->resolver->zones.constraints
                              : 0;
    report->zones = r->zones.zones;
    report->largest_zone = r->zones.largest;
    report->iterations = r->zones.iterations;
    report->violation = r->zones.violation;
    bool has_gap = isfinite(r->zones.smallest_gap) != 0;
    report->smallest_gap = has_gap ? r->zones.smallest_gap : 0;
    if (report->rounds[TF_FAILSAFE] > 0)
        tf_failsafe_account(&r->resolver->failsafe, &r->step, report);
}

//: Resolve a step that has contacts
static tf_status resolve(tf_resolution *r)
{
    choose(r);
    tf_status status = tf_respond(r);
    TF_REQUIRE(status != TF_OK || !r->contacts.any);
    return status;
}

//: Resolve a step
static tf_status run(tf_resolution *r, double end[], tf_obstacle *obstacle)
{
    if (!are_good(&r->options))
        return TF_BAD_OPTION;
    if (r->step.vertices != tf_surface_vertices(r->resolver->surface))
        return TF_BAD_COUNT;
    if (!r->options.narrow_phase)
        r->options.narrow_phase = &tf_vectorized;
    if (!r->step.inverse_mass)
        r->step.inverse_mass = all_ones(r->resolver, r->step.vertices);
    if (!r->step.inverse_mass || !ready(r))
        return TF_OUT_OF_MEMORY;
    tf_status status = check_masses(&r->step, &obstacle->flaw);
    if (status == TF_OK)
        status = begin(r, obstacle);
    if (status == TF_OK && r->contacts.any)
        status = resolve(r);
    if (status != TF_OK)
        return status;
    write_report(r);
    memcpy(end, r->step.end,
           sizeof *end * (size_t)r->step.axes * (size_t)r->step.vertices);
    return TF_OK;
}

tf_status tf_step_resolve(tf_resolver *resolver, int vertices,
                          const double start[], double end[],
                          const double inverse_mass[],
                          const tf_response_options *options,
                          tf_response_report *report, tf_obstacle *obstacle)
{
    TF_REQUIRE(resolver && start && end);
    static const tf_response_options usual;
    tf_resolution r = {.resolver = resolver,
                       .options = options ? *options : usual,
                       .step = {.axes = tf_surface_axes(resolver->surface),
                                .vertices = vertices,
                                .start = start,
                                .proposed = end,
                                .inverse_mass = inverse_mass},
                       .motion = {.vertices = vertices, .start = start},
                       .zones = {.smallest_gap = INFINITY}};
    tf_obstacle none = {.vertex = {-1, -1, -1, -1, -1}};
    if (obstacle)
        *obstacle = none;
    else
        obstacle = &none;
    tf_status status = run(&r, end, obstacle);
    if (status == TF_OK && report)
        *report = r.report;
    return status;
}
