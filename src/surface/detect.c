//: Include what detection needs
#include "surface/detect.h"

#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/functions.h"
#include "arithmetic/published.h"
#include "base/sized.h"
#include "surface/filtered_join.h"
#include "surface/pairs.h"
#include "surface/surface_memory.h"

#include <stdbool.h>
#include <stddef.h>

//: Check that an arithmetic can hold all positions
/// Whether it holds those of a vertex at one end of the step.
static bool holds(const tf_arithmetic *arithmetic, int axes, const double x[],
                  int vertex)
{
    bool held = true;
    for (int k = 0; k < axes; k++)
        held = held && tf_arithmetic_holds(arithmetic, axes,
                                           x[(ptrdiff_t)axes * vertex + k]);
    return held;
}

static tf_status check_range(const tf_pair_job *job, tf_error *error)
{
    const tf_motion *motion = job->motion;
    const double *ends[] = {motion->start, motion->end};
    if (tf_arithmetic_bits(job->arithmetic, motion->axes) == 0)
        return TF_OK;
    for (int v = 0; v < motion->vertices; v++)
        for (int t = 0; t < 2; t++)
            if (!holds(job->arithmetic, motion->axes, ends[t], v))
                return tf_fail_vertex(error, TF_OUT_OF_RANGE, v, t);
    return TF_OK;
}

//: Test whether an arithmetic is certain
/// Whether all that an arithmetic takes for contacts are.  If it isn't, it has to
/// be asked about all pairs whose swept boxes overlap, as a query would be.
static bool is_certain(const tf_arithmetic *arithmetic)
{
    return arithmetic != &tf_clamped && arithmetic != &tf_published;
}

//: Detect the contacts of a surface
static tf_status detect(tf_surface *surface, tf_pair_job *job,
                        const tf_parallel *parallel, tf_contacts *found,
                        tf_error *error)
{
    tf_status status = tf_parallel_check(parallel, error);
    if (status == TF_OK && (unsigned)job->selection > TF_ANY_CONTACT)
        status = tf_fail_option(error, "selection", "one of its enumeration",
                                job->selection);
    if (status == TF_OK)
        status = tf_surface_move(surface, job->motion,
                                 !is_certain(job->arithmetic), parallel, error);
    if (status == TF_OK)
        status = check_range(job, error);
    if (status != TF_OK)
        return status;
    return tf_fail(error, tf_pairs_find(surface, job, parallel, found));
}

//: Detect what is not within zones
/// Leaves zones that the caller has entered as they are.
static tf_status detect_outside(tf_surface *surface, const int zone[],
                                tf_pair_job *job, const tf_parallel *parallel,
                                tf_contacts *found, tf_error *error)
{
    if (!tf_surface_enter_zones(surface, zone))
        return tf_fail(error, TF_OUT_OF_MEMORY);
    tf_status status = detect(surface, job, parallel, found, error);
    if (zone)
        tf_surface_leave_zones(surface);
    return status;
}

//: Read how to detect
tf_status tf_detect_options_read(tf_detect_options *to,
                                 const tf_detect_options *from, tf_error *error)
{
    return tf_options_read(
        to, sizeof *to, from,
        offsetof(tf_detect_options, context) + sizeof to->context, error);
}

//: Detect with the usual choices
tf_status tf_detect(tf_surface *surface, const tf_motion *motion,
                    const tf_detect_options *options, tf_contacts *found,
                    tf_error *error)
{
    static const tf_detect_options usual;
    if (!options)
        options = &usual;
    tf_pair_job job = {
        .surface = surface,
        .motion = motion,
        .arithmetic = options->arithmetic ? options->arithmetic : &tf_exact,
        .narrow_phase =
            options->narrow_phase ? options->narrow_phase : &tf_reference,
        .selection = options->selection};
    tf_watch watch,
        *outer = tf_workers_watch(&surface->workers, &watch, options->progress,
                                  options->context);
    tf_status status = detect_outside(surface, options->zone, &job,
                                      options->parallel, found, error);
    surface->workers.watch = outer;
    return status;
}
