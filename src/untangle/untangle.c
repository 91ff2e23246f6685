//: Include what untangling needs
#include "untangle/untangle.h"

#include "base/fail.h"
#include "base/require.h"
#include "base/sized.h"
#include "response/levels.h"
#include "untangle/attempts.h"

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
    own->fixed = (bool *)(memory + 5 * own->coordinates);
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

//: Untangle what crosses
static tf_status untangle(untangling *own, int vertices, const double in[],
                          tf_crossings *left, double out[])
{
    if (!begin(own, vertices, in))
        return TF_OUT_OF_MEMORY;
    tf_status status = tf_attempt(&own->attempts);
    if (status != TF_OK)
        return status;
    double *last = own->attempts.next;
    scale_back(own, last);
    tf_check_options options = {.parallel = own->options.parallel};
    status = tf_surface_check(own->resolver->surface, vertices, last, &options,
                              left, NULL);
    if (status == TF_OK)
        memcpy(out, last, own->coordinates * sizeof *out);
    return status;
}

//: Untangle a surface
static tf_status check_and_untangle(untangling *own, int vertices,
                                    const double in[], double out[],
                                    tf_crossings *left, tf_error *error)
{
    tf_surface *surface = own->resolver->surface;
    tf_check_options options = {.parallel = own->options.parallel};
    tf_status status =
        tf_surface_check(surface, vertices, in, &options, left, error);
    if (status != TF_OK)
        return status;
    own->report.before = left->count;
    if (left->count > 0) {
        status = untangle(own, vertices, in, left, out);
        end(own);
    } else if (out != in) {
        memcpy(out, in, (size_t)surface->axes * (size_t)vertices * sizeof *in);
    }
    own->report.left = left->count;
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
    workers->watch = outer;
    if (status == TF_OK && report)
        *report = own.report;
    if (status == TF_OK && left)
        *left = crossings;
    return status;
}
