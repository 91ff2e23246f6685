//: Include what resolving needs
#include "response/resolve.h"

#include "base/fail.h"
#include "base/require.h"
#include "fast/estimate.h"
#include "response/choices.h"
#include "response/levels.h"
#include "response/start.h"
#include "surface/filtered_join.h"

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

//: Check the friction of vertices
static tf_status check_friction(int vertices, const double friction[],
                                tf_error *error)
{
    for (int v = 0; friction && v < vertices; v++)
        if (!(friction[v] >= 0) || !isfinite(friction[v]))
            return tf_fail_vertex_option(error, "vertex_friction",
                                         "finite, 0 or more", v, friction[v]);
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

static bool has_scripted(const tf_step *step)
{
    for (int v = 0; v < step->vertices; v++)
        if (!(step->inverse_mass[v] > 0))
            return true;
    return false;
}

static bool reserve(tf_resolution *r)
{
    tf_resolver *resolver = r->resolver;
    size_t vertices = (size_t)r->step.vertices;
    size_t bytes = sizeof(double) * (size_t)r->step.axes * vertices;
    return tf_buffer_reserve(&resolver->end, bytes, 1) &&
           tf_buffer_reserve(&resolver->unpushed, bytes, 1) &&
           tf_buffer_reserve(&resolver->flags, 2 * vertices, 1) &&
           tf_buffer_reserve(&resolver->followed, vertices, sizeof(double)) &&
           (r->parts == 1 || tf_buffer_reserve(&resolver->part, 3 * bytes, 1));
}

static void ready(tf_resolution *r)
{
    tf_resolver *resolver = r->resolver;
    size_t vertices = (size_t)r->step.vertices;
    size_t bytes = sizeof(double) * (size_t)r->step.axes * vertices;
    r->step.flags = (unsigned char *)resolver->flags.data + vertices;
    memset(r->step.flags, 0, vertices);
    r->step.end = memcpy(resolver->end.data, r->step.proposed, bytes);
    r->step.unpushed = memcpy(resolver->unpushed.data, r->step.proposed, bytes);
    r->motion.start = r->step.start;
    r->motion.end = r->step.end;
    r->search = (tf_contact_search){.surface = resolver->surface,
                                    .motion = &r->motion,
                                    .narrow_phase = r->options.narrow_phase,
                                    .estimate = tf_contact_estimate,
                                    .parallel = r->options.parallel};
    r->zones = (tf_zone_statistics){.smallest_gap = INFINITY};
    r->report = (tf_response_report){0};
}

//: Count what starts too near
static tf_status count_near_at_start(tf_resolution *r, tf_error *error)
{
    tf_thickness *thickness = &r->resolver->thickness;
    thickness->length = r->rule.thickness = r->options.thickness;
    if (!(thickness->length > 0))
        return TF_OK;
    tf_motion motion = {r->step.axes, r->step.vertices, r->start, r->start};
    return tf_near_contacts_count_start(thickness, r->resolver->surface,
                                        &motion, r->options.parallel,
                                        &r->whole.near_at_start, error);
}

//: Remember where a step starts
/// What has to be the same if a step is to be answered again.
enum {
    ORIGIN_PARTS = 3
};

typedef struct step_origin {
    const void *part[ORIGIN_PARTS];
    size_t bytes[ORIGIN_PARTS], all;
} step_origin;

static step_origin origin_of(const tf_resolution *r)
{
    const tf_step *step = &r->step;
    const tf_surface *surface = r->resolver->surface;
    size_t vertices = (size_t)step->vertices,
           positions = sizeof(double) * (size_t)step->axes * vertices,
           masses = sizeof(double) * vertices,
           facets = (size_t)(step->axes == 2 ? surface->edges.count
                                             : surface->triangles.count),
           zones = r->options.zone ? sizeof(int) * facets : 0;
    return (step_origin){{step->start, step->inverse_mass, r->options.zone},
                         {positions, masses, zones},
                         positions + masses + zones};
}

static bool note_origin(tf_resolution *r)
{
    tf_resolver *resolver = r->resolver;
    step_origin own = origin_of(r);
    if (!tf_buffer_reserve(&resolver->origin, own.all, 1))
        return false;
    char *noted = resolver->origin.data;
    for (int i = 0; i < ORIGIN_PARTS; noted += own.bytes[i++])
        if (own.bytes[i] > 0)
            memcpy(noted, own.part[i], own.bytes[i]);
    resolver->origin_bytes = own.all;
    return true;
}

static bool has_origin(const tf_resolution *r)
{
    const tf_resolver *resolver = r->resolver;
    step_origin own = origin_of(r);
    const char *noted = resolver->origin.data;
    bool same = resolver->has_resolved && resolver->origin_bytes == own.all;
    for (int i = 0; i < ORIGIN_PARTS && same; noted += own.bytes[i++])
        same =
            own.bytes[i] == 0 || memcmp(noted, own.part[i], own.bytes[i]) == 0;
    return same;
}

//: Detect what the proposal does
static bool is_finite(const tf_step *step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)step->axes * step->vertices; i++)
        if (!isfinite(step->proposed[i]))
            return false;
    return true;
}

/// Whether the pairs that the resolver keeps are of this step.
static bool keeps_pairs(const tf_resolution *r)
{
    return r->options.again && has_origin(r) && is_finite(&r->step);
}

static tf_status begin(tf_resolution *r, tf_error *error)
{
    tf_status status = TF_OK;
    if (r->options.check_start)
        status = tf_start_check(r->resolver->surface, &r->motion,
                                r->options.parallel, error);
    if (status == TF_OK)
        status = keeps_pairs(r) ? tf_fail(error, tf_resolution_detect_again(r))
                                : tf_resolution_detect(r, error);
    r->report.first_contacts = r->report.contacts;
    r->report.first_near = r->report.near;
    return status == TF_OK ? tf_start_check_contacts(&r->motion, &r->contacts,
                                                     r->step.watch, error)
                           : status;
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

//: Resolve a part of a step that has contacts
static tf_status answer(tf_resolution *r)
{
    tf_response_options_choose(&r->options, r->resolver->surface, &r->step);
    r->rule.separation = r->options.separation;
    r->rule.restitution = r->options.restitution;
    r->rule.threshold = r->options.restitution_threshold / r->parts;
    tf_status status = tf_respond(r);
    TF_REQUIRE(status != TF_OK || r->options.draft || !r->contacts.any);
    return status;
}

static tf_status answer_any(tf_resolution *r, tf_error *error)
{
    ready(r);
    // Without a round of the failsafe each vertex is a group of its own.
    if (!tf_groups_begin(&r->resolver->failsafe.groups, r->step.vertices))
        return tf_fail(error, TF_OUT_OF_MEMORY);
    tf_status status = begin(r, error);
    if (status == TF_OK && r->contacts.any)
        status = tf_fail(error, answer(r));
    tf_detect_statistics_add(&r->whole.statistics, &r->report.statistics);
    return status;
}

//: Shorten what scripted vertices cannot follow
/// Tries how far the scripted vertices can go that the step, once resolved, holds
/// back.  What is kept is the last trial, a resolved step as any other.
static tf_status shorten(tf_resolution *r, tf_error *error)
{
    tf_resolver *resolver = r->resolver;
    const double *proposed = r->step.proposed;
    size_t first_contacts = r->report.first_contacts,
           first_near = r->report.first_near;
    if (!tf_follow_begin(&resolver->follow, &r->step))
        return tf_fail(error, TF_OUT_OF_MEMORY);
    r->rule.squeezed = resolver->follow.squeezed.data;
    tf_status status = TF_OK;
    while (status == TF_OK && tf_follow_learn(&resolver->follow, &r->step,
                                              &resolver->failsafe.groups)) {
        r->step.proposed = tf_follow_propose(
            &resolver->follow, &r->step, proposed, &resolver->surface->edges);
        tf_answers_drop(&resolver->answers);
        status = r->step.proposed ? answer_any(r, error)
                                  : tf_fail(error, TF_CANCELLED);
    }
    r->rule.squeezed = NULL;
    r->report.first_contacts = first_contacts;
    r->report.first_near = first_near;
    return status;
}

//: Begin a part of a step
/// Where vertices start in a part, where they are proposed to end, and where they
/// would be at the end of the step if nothing met any more.
typedef struct part_positions {
    double *start, *end, *target;
} part_positions;

static part_positions part_positions_of(const tf_resolution *r)
{
    ptrdiff_t numbers = (ptrdiff_t)r->step.axes * r->step.vertices;
    double *all = r->resolver->part.data;
    if (r->parts == 1) // it needs none
        return (part_positions){0};
    return (part_positions){all, all + numbers, all + 2 * numbers};
}

/// Has each vertex go straight on to its target.
static void begin_part(tf_resolution *r, int part)
{
    ptrdiff_t numbers = (ptrdiff_t)r->step.axes * r->step.vertices;
    size_t bytes = sizeof(double) * (size_t)numbers;
    part_positions at = part_positions_of(r);
    int left = r->parts - part;
    memcpy(at.start, part == 0 ? r->start : r->step.end, bytes);
    if (part == 0)
        memcpy(at.target, r->proposed, bytes);
    for (ptrdiff_t i = 0; i < numbers; i++)
        at.end[i] = left == 1
                        ? at.target[i]
                        : tf_step_part(at.start[i], at.target[i], 1.0 / left);
    r->step.start = at.start;
    r->step.proposed = at.end;
}

//: End a part of a step
static bool is_scripted(const tf_step *step, int vertex)
{
    return !(step->inverse_mass[vertex] > 0);
}

/// Whether a response has changed where a vertex ends or how it moves.
static bool is_changed(const tf_step *step, int vertex)
{
    size_t bytes = sizeof(double) * (size_t)step->axes;
    ptrdiff_t place = (ptrdiff_t)step->axes * vertex;
    const double *proposed = step->proposed + place;
    return memcmp(step->end + place, proposed, bytes) != 0 ||
           memcmp(step->unpushed + place, proposed, bytes) != 0;
}

//: Choose how a vertex goes on
/// So many times a displacement, from some position on; this itself if that is
/// not finite.
static double extended(double origin, double displacement, int times)
{
    double x = origin + times * displacement;
    return isfinite(x) ? x : origin;
}

/// The displacement with which a vertex is to begin the next part: that of the
/// proposed step, as if every part began a step of its own.  But what bounces
/// keeps the velocity that it is left with.
static double next_displacement(const tf_resolution *r, const double start[],
                                ptrdiff_t i)
{
    return r->options.restitution > 0
               ? r->step.unpushed[i] - start[i]
               : (r->proposed[i] / 2 - r->start[i] / 2) / r->parts * 2;
}

static void end_part(tf_resolution *r, int part)
{
    const tf_step *step = &r->step;
    part_positions at = part_positions_of(r);
    int left = r->parts - 1 - part;
    unsigned char *flags = r->resolver->flags.data;
    for (int v = 0; v < step->vertices; v++) {
        flags[v] |= step->flags[v];
        if (is_scripted(step, v) || !is_changed(step, v))
            continue;
        flags[v] |= TF_VERTEX_MOVED;
        for (int k = 0; k < step->axes && left > 0; k++) {
            ptrdiff_t i = (ptrdiff_t)step->axes * v + k;
            double displacement = next_displacement(r, step->start, i);
            at.target[i] = extended(step->end[i], displacement, left);
        }
    }
}

//: Find the motion of all parts
/// The velocity of a vertex is the one that it has in the last part.
static void find_motion(tf_resolution *r)
{
    const tf_step *step = &r->step;
    const unsigned char *flags = r->resolver->flags.data;
    for (int v = 0; v < step->vertices; v++)
        for (int k = 0; k < step->axes; k++) {
            ptrdiff_t i = (ptrdiff_t)step->axes * v + k;
            if (is_scripted(step, v))
                step->unpushed[i] = step->end[i];
            else if (flags[v] & TF_VERTEX_MOVED)
                step->unpushed[i] = extended(
                    r->start[i], step->unpushed[i] - step->start[i], r->parts);
        }
}

//: Report a part of a step
static void add_report(tf_resolution *r)
{
    tf_response_report *own = &r->report, *all = &r->whole;
    all->first_contacts += own->first_contacts;
    all->contacts += own->contacts;
    all->first_near += own->first_near;
    all->near += own->near;
    for (int level = 0; level < TF_LEVELS; level++)
        all->rounds[level] += own->rounds[level];
    if (own->rounds[TF_ZONES] > 0)
        all->constraints += (size_t)r->resolver->zones.constraints;
    all->zones += r->zones.zones;
    if (r->zones.largest > all->largest_zone)
        all->largest_zone = r->zones.largest;
    all->iterations += r->zones.iterations;
    all->violation = fmax(all->violation, r->zones.violation);
    r->smallest_gap = fmin(r->smallest_gap, r->zones.smallest_gap);
    if (own->rounds[TF_FAILSAFE] > 0)
        all->groups += tf_failsafe_mark(&r->resolver->failsafe, &r->step);
}

//: Report what became of vertices
/// The fraction of its way on which a vertex ends, by the axis along which
/// that is the longest.
static double fraction_of(const double start[], const double end[],
                          const double proposed[], int axes)
{
    double longest = 0, fraction = 1;
    for (int k = 0; k < axes; k++) {
        double way = proposed[k] / 2 - start[k] / 2;
        if (!(fabs(way) > longest))
            continue;
        longest = fabs(way);
        fraction = (end[k] / 2 - start[k] / 2) / way;
    }
    return fmin(fmax(fraction, 0), 1);
}

static void report_vertices(tf_resolution *r)
{
    const tf_step *step = &r->step;
    tf_response_report *report = &r->whole;
    unsigned char *flags = r->resolver->flags.data;
    double *followed = r->resolver->followed.data;
    report->followed = 1;
    for (int v = 0; v < step->vertices; v++) {
        ptrdiff_t i = (ptrdiff_t)step->axes * v;
        bool moved = memcmp(step->end + i, r->proposed + i,
                            sizeof(double) * (size_t)step->axes) != 0;
        bool held = moved && is_scripted(step, v);
        followed[v] = held ? fraction_of(r->start + i, step->end + i,
                                         r->proposed + i, step->axes)
                           : 1;
        flags[v] = (unsigned char)((flags[v] & ~TF_VERTEX_MOVED) |
                                   (moved ? TF_VERTEX_MOVED : 0) |
                                   (held ? TF_VERTEX_HELD : 0));
        report->moved += moved;
        report->held += held;
        report->grouped += (flags[v] & TF_VERTEX_GROUPED) != 0;
        report->resting += (flags[v] & TF_VERTEX_RESTING) != 0;
        report->followed = fmin(report->followed, followed[v]);
    }
}

//: Write the report
static void write_report(tf_resolution *r)
{
    tf_response_report *report = &r->whole;
    tf_step whole = r->step;
    whole.start = r->start;
    report->energy_before = energy(&whole, r->proposed);
    report->energy_after = energy(&whole, whole.unpushed);
    bool has_gap = isfinite(r->smallest_gap) != 0;
    report->smallest_gap = has_gap ? r->smallest_gap : 0;
    report_vertices(r);
}

//: Resolve a part of a step
static tf_status resolve_part(tf_resolution *r, int part, tf_error *error)
{
    tf_resolver *resolver = r->resolver;
    if (r->parts > 1)
        begin_part(r, part);
    tf_status status = answer_any(r, error);
    if (status == TF_OK && tf_follow_is_held(&r->step))
        status = shorten(r, error);
    if (status != TF_OK)
        return status;
    add_report(r);
    r->options.check_start = false; // what follows starts where this has ended
    if (r->parts > 1 &&
        !tf_answers_settle(&resolver->answers, resolver->zones.constraint.data,
                           resolver->zones.gap.data, part, r->parts))
        return tf_fail(error, TF_OUT_OF_MEMORY);
    end_part(r, part);
    return TF_OK;
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
    if (!r->step.inverse_mass || !reserve(r))
        return tf_fail(error, TF_OUT_OF_MEMORY);
    status =
        check_friction(r->step.vertices, r->options.vertex_friction, error);
    return status == TF_OK ? check_masses(&r->step, error) : status;
}

static tf_status run(tf_resolution *r, double end[], tf_error *error)
{
    size_t vertices = (size_t)r->step.vertices;
    memset(r->resolver->flags.data, 0, vertices);
    tf_status status = count_near_at_start(r, error);
    for (int part = 0; part < r->parts && status == TF_OK; part++)
        status = resolve_part(r, part, error);
    if (status != TF_OK)
        return status;
    if (r->parts > 1)
        find_motion(r);
    write_report(r);
    bool may_return = r->parts == 1 && (r->options.draft || r->options.again);
    r->resolver->origin_bytes = 0;
    if (may_return && !note_origin(r))
        return tf_fail(error, TF_OUT_OF_MEMORY);
    memcpy(end, r->step.end, sizeof *end * (size_t)r->step.axes * vertices);
    return TF_OK;
}

/// Has the surface leave out pairs that nothing can be done about, for a while.
static tf_status watch_and_run(tf_resolution *r, double end[], tf_error *error)
{
    tf_surface *surface = r->resolver->surface;
    tf_watch watch,
        *outer = tf_workers_watch(&surface->workers, &watch,
                                  r->options.progress, r->options.context);
    r->step.watch = surface->workers.watch;
    tf_status status = check(r, error);
    if (status == TF_OK) {
        surface->inverse_mass =
            has_scripted(&r->step) ? r->step.inverse_mass : NULL;
        status = tf_surface_enter_zones(surface, r->options.zone)
                     ? run(r, end, error)
                     : tf_fail(error, TF_OUT_OF_MEMORY);
        tf_surface_leave_zones(surface);
        surface->inverse_mass = NULL;
    }
    surface->workers.watch = outer;
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
    tf_resolution r = {.resolver = resolver,
                       .step = {.axes = axes,
                                .vertices = vertices,
                                .start = start,
                                .proposed = end,
                                .inverse_mass = inverse_mass},
                       .motion = {.axes = axes, .vertices = vertices},
                       .start = start,
                       .proposed = end,
                       .smallest_gap = INFINITY};
    tf_answers_clear(&resolver->answers);
    tf_status status = tf_response_options_read(&r.options, options, error);
    r.parts = r.options.substeps > 1 ? r.options.substeps : 1;
    if (status == TF_OK)
        status = watch_and_run(&r, end, error);
    resolver->report = r.whole;
    resolver->has_resolved = status == TF_OK;
    if (status != TF_OK)
        tf_answers_clear(&resolver->answers);
    else if (report)
        *report = &resolver->report;
    return status;
}
