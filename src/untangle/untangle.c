//: Include what untangling needs
#include "untangle/untangle.h"

#include "base/fail.h"
#include "base/require.h"
#include "base/sized.h"
#include "response/levels.h"
#include "untangle/attempts.h"
#include "untangle/measures.h"
#include "untangle/way_home.h"

#include <string.h>

//: Read how to untangle
static tf_status read_options(tf_untangle_options *own,
                              const tf_untangle_options *options,
                              tf_error *error)
{
    size_t first = offsetof(tf_untangle_options, context) + sizeof own->context;
    int all = 2 * TF_RUNG_RETURN - 1;
    tf_status status = tf_options_read(own, sizeof *own, options, first, error);
    if (status != TF_OK)
        return status;
    if (own->rounds < 0)
        return tf_fail_option(error, "rounds", "0 or more", own->rounds);
    if (own->without < 0 || own->without > all)
        return tf_fail_option(error, "without", "a sum of rungs", own->without);
    return TF_OK;
}

//: Hold an untangling
typedef struct untangling {
    tf_resolver *resolver;
    tf_untangle_options options;
    size_t coordinates;
    int power;     ///< the scale, a power of two
    double *in;    ///< the input, scaled
    double *given; ///< the input as it was given
    bool *fixed;
    tf_attempts attempts;
    tf_untangle_report report;
    tf_buffer storage;
} untangling;

//: Begin an untangling
static bool reserve(untangling *own, int vertices)
{
    size_t size = own->coordinates * sizeof(double);
    if (!tf_buffer_reserve(&own->storage, 5 * size + (size_t)vertices, 1))
        return false;
    double *memory = own->storage.data;
    own->in = memory;
    own->given = memory + own->coordinates;
    own->attempts.x = memory + 2 * own->coordinates;
    own->attempts.next = memory + 3 * own->coordinates;
    own->attempts.best = memory + 4 * own->coordinates;
    own->fixed = (void *)(memory + 5 * own->coordinates);
    return true;
}

static bool begin(untangling *own, int vertices, const double in[])
{
    tf_surface *surface = own->resolver->surface;
    own->coordinates = (size_t)surface->axes * (size_t)vertices;
    if (!reserve(own, vertices))
        return false;
    memcpy(own->given, in, own->coordinates * sizeof *in);
    own->power = tf_scale_of(own->coordinates, in);
    tf_scale_by(own->coordinates, in, -own->power, own->in);
    for (int v = 0; v < vertices; v++)
        own->fixed[v] = own->options.fixed && own->options.fixed[v];
    tf_tangle *tangle = &own->attempts.tangle;
    tangle->surface = surface;
    tangle->parallel = own->options.parallel;
    tangle->watch = surface->workers.watch;
    tangle->fixed = own->fixed;
    tangle->in = own->in;
    own->attempts.options = &own->options;
    own->attempts.extends = own->options.rounds <= 0;
    size_t size = own->coordinates * sizeof *in;
    memcpy(own->attempts.best, own->in, size);
    memcpy(own->attempts.next, in, size);
    return tf_tangle_begin(tangle);
}

//: End an untangling
static void end(untangling *own)
{
    tf_attempts_free(&own->attempts);
    tf_tangle_end(&own->attempts.tangle);
    tf_buffer_free(&own->storage);
}

//: Scale back
/// What did not move is as it was given, bit for bit.
static void scale_back(const untangling *own, double out[])
{
    const double *best = own->attempts.best;
    tf_scale_by(own->coordinates, best, own->power, out);
    for (size_t i = 0; i < own->coordinates; i++)
        if (best[i] == own->in[i])
            out[i] = own->given[i];
}

//: Return from a clear state
static tf_status go_home(untangling *own)
{
    tf_attempts *all = &own->attempts;
    if (all->fewest > all->beyond)
        return TF_OK;
    own->report.found =
        ldexp(tf_deviation(&all->tangle, all->best), own->power);
    if (own->options.without & TF_RUNG_RETURN)
        return TF_OK;
    tf_way_home way = {.steps = 0};
    tf_status status =
        tf_way_home_take(&way, own->resolver, &all->tangle, all->best);
    tf_way_home_free(&way);
    all->rungs |= way.steps > 0 ? TF_RUNG_RETURN : 0;
    return status;
}

//: Check the output
/// Lists the crossings of the output, which is left in `next`.  Where
/// coordinates are so small that they cannot be scaled exactly, rounding may
/// make some, and where they are nearly the largest there are, what moves may
/// become infinite; if there are more than before, or if so, nothing moves.
static tf_status check_output(untangling *own, int vertices, tf_crossings *left)
{
    tf_surface *surface = own->resolver->surface;
    tf_attempts *all = &own->attempts;
    tf_check_options options = {.parallel = own->options.parallel};
    scale_back(own, all->next);
    tf_status status =
        tf_surface_check(surface, vertices, all->next, &options, left, NULL);
    bool is_worse = status == TF_OK && left->count > own->report.before;
    if (!is_worse && status != TF_NOT_FINITE)
        return status;
    memcpy(all->best, own->in, own->coordinates * sizeof *own->in);
    memcpy(all->next, own->given, own->coordinates * sizeof *own->in);
    return tf_surface_check(surface, vertices, all->next, &options, left, NULL);
}

//: Report on an untangling
static tf_status report_on(untangling *own, const tf_crossings *left)
{
    const tf_attempts *all = &own->attempts;
    own->report.left = left->count;
    own->report.beyond = all->beyond;
    own->report.parts = all->tangle.near.parts;
    own->report.rounds = all->rounds;
    own->report.rungs = all->rungs;
    bool measured =
        tf_measure(&all->tangle, all->best, own->power, &own->report);
    return measured ? TF_OK : TF_OUT_OF_MEMORY;
}

//: Untangle what crosses
static tf_status untangle(untangling *own, int vertices, tf_crossings *left)
{
    tf_status status = tf_attempt(&own->attempts);
    if (status == TF_OK)
        status = go_home(own);
    return status == TF_OK ? check_output(own, vertices, left) : status;
}

//: Untangle a surface
static tf_status check_and_untangle(untangling *own, int vertices,
                                    const double in[], double out[],
                                    tf_crossings *left, tf_error *error)
{
    tf_check_options options = {.parallel = own->options.parallel};
    tf_status status = tf_surface_check(own->resolver->surface, vertices, in,
                                        &options, left, error);
    if (status != TF_OK)
        return status;
    own->report.before = left->count;
    if (!begin(own, vertices, in))
        return tf_fail(error, TF_OUT_OF_MEMORY);
    if (left->count > 0)
        status = untangle(own, vertices, left);
    if (status == TF_OK)
        status = report_on(own, left);
    if (status == TF_OK)
        memcpy(out, own->attempts.next, own->coordinates * sizeof *out);
    return tf_fail(error, status);
}

tf_status tf_untangle(tf_resolver *resolver, int vertices, const double in[],
                      double out[], const tf_untangle_options *options,
                      tf_untangle_report *report, tf_crossings *left,
                      tf_error *error)
{
    TF_REQUIRE(resolver && in && out);
    untangling own = {.resolver = resolver};
    tf_crossings crossings;
    tf_status status = read_options(&own.options, options, error);
    if (status != TF_OK)
        return status;
    tf_workers *workers = &resolver->surface->workers;
    tf_watch watch,
        *outer = tf_workers_watch(workers, &watch, own.options.progress,
                                  own.options.context);
    status = check_and_untangle(&own, vertices, in, out, &crossings, error);
    end(&own);
    workers->watch = outer;
    if (status == TF_OK && report)
        *report = own.report;
    if (status == TF_OK && left)
        *left = crossings;
    return status;
}
