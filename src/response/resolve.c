//: Include what resolving needs
#include "response/resolve.h"

#include "base/fail.h"
#include "base/require.h"
#include "fast/estimate.h"
#include "response/choices.h"
#include "response/levels.h"
#include "response/start.h"

#include <math.h>
#include <string.h>

//: Check the masses
static tf_status check_masses(const tf_step *step, tf_error *error)
{
    for (int v = 0; v < step->vertices; v++)
        if (!(step->inverse_mass[v] >= 0) || !isfinite(step->inverse_mass[v]))
            return tf_fail_vertex(error, TF_BAD_MASS, v, -1);
    return TF_OK;
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
    if (!tf_buffer_reserve(&resolver->end, bytes, 1) ||
        !tf_buffer_reserve(&resolver->unpushed, bytes, 1) ||
        !tf_buffer_reserve(&resolver->flags, vertices, 1))
        return false;
    r->step.flags = memset(resolver->flags.data, 0, vertices);
    r->step.end = memcpy(resolver->end.data, r->step.proposed, bytes);
    r->step.unpushed = memcpy(resolver->unpushed.data, r->step.proposed, bytes);
    r->motion.end = r->step.end;
    r->search = (tf_contact_search){.surface = resolver->surface,
                                    .motion = &r->motion,
                                    .narrow_phase = r->options.narrow_phase,
                                    .estimate = tf_contact_estimate,
                                    .parallel = r->options.parallel};
    return true;
}

//: Count what starts too near
static tf_status begin_thickness(tf_resolution *r, tf_error *error)
{
    tf_thickness *thickness = &r->resolver->thickness;
    thickness->length = r->rule.thickness = r->options.thickness;
    if (!(thickness->length > 0))
        return TF_OK;
    return tf_near_contacts_count_start(thickness, r->resolver->surface,
                                        &r->motion, r->options.parallel,
                                        &r->report.near_at_start, error);
}

//: Detect what the proposal does
static tf_status begin(tf_resolution *r, tf_error *error)
{
    tf_status status = TF_OK;
    if (r->options.check_start)
        status = tf_start_check(r->resolver->surface, &r->motion,
                                r->options.parallel, error);
    if (status == TF_OK)
        status = begin_thickness(r, error);
    if (status == TF_OK)
        status = tf_pair_cache_build(&r->resolver->pairs, &r->search,
                                     &r->contacts, error);
    if (status == TF_OK)
        status = tf_start_check_contacts(&r->motion, &r->contacts,
                                         r->step.watch, error);
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
        bool held = moved && !(step->inverse_mass[v] > 0);
        step->flags[v] |=
            (moved ? TF_VERTEX_MOVED : 0) | (held ? TF_VERTEX_HELD : 0);
        report->moved += moved;
        report->held += held;
    }
}

static void write_report(tf_resolution *r)
{
    tf_response_report *report = &r->report;
    report->energy_before = energy(&r->step, r->step.proposed);
    report->energy_after = energy(&r->step, r->step.unpushed);
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
    tf_response_options_choose(&r->options, r->resolver->surface, &r->step);
    r->rule.separation = r->options.separation;
    r->rule.restitution = r->options.restitution;
    r->rule.threshold = r->options.restitution_threshold;
    tf_status status = tf_respond(r);
    TF_REQUIRE(status != TF_OK || !r->contacts.any);
    return status;
}

//: Resolve a step
static tf_status check(tf_resolution *r, tf_error *error)
{
    tf_status status = tf_response_options_check(&r->options, error);
    if (status != TF_OK)
        return status;
    if (r->step.vertices != tf_surface_vertices(r->resolver->surface))
        return tf_fail(error, TF_BAD_COUNT);
    if (!r->step.inverse_mass)
        r->step.inverse_mass = all_ones(r->resolver, r->step.vertices);
    if (!r->step.inverse_mass || !ready(r))
        return tf_fail(error, TF_OUT_OF_MEMORY);
    return check_masses(&r->step, error);
}

static tf_status run(tf_resolution *r, double end[], tf_error *error)
{
    tf_status status = check(r, error);
    if (status == TF_OK)
        status = begin(r, error);
    if (status == TF_OK)
        status = tf_resolution_find_near(r, error);
    r->report.first_near = r->report.near;
    if (status == TF_OK && r->contacts.any)
        status = tf_fail(error, resolve(r));
    if (status != TF_OK)
        return status;
    write_report(r);
    memcpy(end, r->step.end,
           sizeof *end * (size_t)r->step.axes * (size_t)r->step.vertices);
    return TF_OK;
}

static tf_status watch_and_run(tf_resolution *r, double end[], tf_error *error)
{
    tf_workers *workers = &r->resolver->surface->workers;
    tf_watch watch,
        *outer = tf_workers_watch(workers, &watch, r->options.progress,
                                  r->options.context);
    r->step.watch = workers->watch;
    tf_status status = run(r, end, error);
    workers->watch = outer;
    return status;
}

//: Resolve with the usual choices
tf_status tf_step_resolve(tf_resolver *resolver, int vertices,
                          const double start[], double end[],
                          const double inverse_mass[],
                          const tf_response_options *options,
                          const tf_response_report **report, tf_error *error)
{
    TF_REQUIRE(resolver && start && end);
    int axes = tf_surface_axes(resolver->surface);
    tf_resolution r = {
        .resolver = resolver,
        .step = {.axes = axes,
                 .vertices = vertices,
                 .start = start,
                 .proposed = end,
                 .inverse_mass = inverse_mass},
        .motion = {.axes = axes, .vertices = vertices, .start = start},
        .zones = {.smallest_gap = INFINITY}};
    tf_answers_clear(&resolver->answers);
    tf_status status = tf_response_options_read(&r.options, options, error);
    if (status == TF_OK)
        status = watch_and_run(&r, end, error);
    resolver->report = r.report;
    resolver->has_resolved = status == TF_OK;
    if (status != TF_OK)
        tf_answers_clear(&resolver->answers);
    else if (report)
        *report = &resolver->report;
    return status;
}
