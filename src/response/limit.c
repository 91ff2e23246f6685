//: Include what the limit of a step needs
#include "response/limit.h"

#include "base/fail.h"
#include "base/require.h"
#include "fast/detect.h"
#include "response/choices.h"
#include "response/levels.h"
#include "response/start.h"
#include "surface/filtered_join.h"

#include <math.h>
#include <string.h>

//: Take a fraction of a step
/// Halves both positions first, because their difference may overflow.  Returns
/// whether any vertex moves.
static bool take_fraction(const double start[], const double proposed[],
                          size_t numbers, int halvings, double end[])
{
    bool moves = false;
    for (size_t i = 0; i < numbers; i++) {
        double half = proposed[i] / 2 - start[i] / 2;
        end[i] = start[i] + ldexp(half, 1 - halvings);
        moves |= end[i] != start[i];
    }
    return moves;
}

//: Halve a step until it is clear
/// Tries k = 1, 2, ... and sets `*halvings` to the first k whose step is clear,
/// or to -1 if nothing moves any more.  Returns the status of the last
/// detection.
static tf_status halve(tf_surface *surface, tf_detect_options *detection,
                       const double start[], const double proposed[],
                       double end[], int *halvings, tf_error *error)
{
    int vertices = tf_surface_vertices(surface);
    size_t numbers = (size_t)tf_surface_axes(surface) * (size_t)vertices;
    tf_motion motion = {tf_surface_axes(surface), vertices, start, end};
    tf_contacts found = {.any = true};
    tf_status status = TF_OK;
    detection->selection = TF_ANY_CONTACT;
    for (int k = 1; status == TF_OK && found.any && *halvings >= 0; k++) {
        bool moves = take_fraction(start, proposed, numbers, k, end);
        *halvings = moves ? k : -1;
        if (moves)
            status =
                tf_surface_detect(surface, &motion, detection, &found, error);
    }
    return status;
}

//: Test a start and a whole step
/// Sets `*clear` to whether the whole step is clear.
static tf_status test_whole(tf_surface *surface, const tf_motion *motion,
                            const tf_response_options *options,
                            const tf_detect_options *detection, bool *clear,
                            tf_error *error)
{
    tf_status status = TF_OK;
    tf_contacts found;
    if (options->check_start)
        status = tf_start_check(surface, motion, options->parallel, error);
    if (status == TF_OK)
        status = tf_surface_detect(surface, motion, detection, &found, error);
    if (status != TF_OK)
        return status;
    *clear = !found.any;
    return tf_start_check_contacts(motion, &found, surface->workers.watch,
                                   error);
}

//: Find a clear fraction
static tf_status limit(tf_resolver *resolver, const double start[],
                       double end[], const tf_response_options *options,
                       int *halvings, tf_error *error)
{
    tf_surface *surface = resolver->surface;
    tf_detect_options detection = {.narrow_phase = options->narrow_phase,
                                   .parallel = options->parallel};
    tf_motion motion = {tf_surface_axes(surface), tf_surface_vertices(surface),
                        start, end};
    size_t bytes = sizeof(double) * (size_t)tf_surface_axes(surface) *
                   (size_t)motion.vertices;
    bool clear = false;
    int found = 0;
    if (!tf_buffer_reserve(&resolver->end, bytes, 1))
        return tf_fail(error, TF_OUT_OF_MEMORY);
    tf_status status =
        test_whole(surface, &motion, options, &detection, &clear, error);
    if (status == TF_OK && !clear)
        status = halve(surface, &detection, start, end, resolver->end.data,
                       &found, error);
    if (status != TF_OK)
        return status;
    *halvings = found;
    if (!clear)
        memcpy(end, resolver->end.data, bytes);
    return TF_OK;
}

tf_status tf_step_limit(tf_resolver *resolver, int vertices,
                        const double start[], double end[],
                        const tf_response_options *options, int *halvings,
                        tf_error *error)
{
    TF_REQUIRE(resolver && start && end && halvings);
    tf_response_options own;
    tf_answers_clear(&resolver->answers);
    resolver->has_resolved = false;
    tf_status status = tf_response_options_read(&own, options, error);
    if (status != TF_OK)
        return status;
    if (vertices != tf_surface_vertices(resolver->surface))
        return tf_fail(error, TF_BAD_COUNT);
    tf_workers *workers = &resolver->surface->workers;
    tf_watch watch,
        *outer = tf_workers_watch(workers, &watch, own.progress, own.context);
    status = tf_surface_enter_zones(resolver->surface, own.zone)
                 ? limit(resolver, start, end, &own, halvings, error)
                 : tf_fail(error, TF_OUT_OF_MEMORY);
    tf_surface_leave_zones(resolver->surface);
    workers->watch = outer;
    return status;
}
