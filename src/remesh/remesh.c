//: Include what remeshing needs
#include "remesh/remesh.h"

#include "base/environment.h"
#include "base/require.h"
#include "base/sized.h"
#include "remesh/corner_origins.h"
#include "remesh/keep_shape.h"
#include "remesh/measure.h"
#include "remesh/passes.h"
#include "remesh/reach.h"
#include "remesh/sizes.h"
#include "surgery/draft.h"
#include "surgery/star.h"

#include <stddef.h>

enum {
    USUAL_ROUNDS = 5,
    USUAL_BOUNDED_ROUNDS = 10, ///< within a distance
    MOST_REFINEMENTS = 30,
    USUAL_CREASE = 25 ///< degrees
};

//: Measure the quality of a surface
static tf_status measure_quality(const tf_adaptive_surface *surface,
                                 double *least, double *mean)
{
    double sum = 0;
    *least = 1;
    for (int t = 0; t < surface->triangles; t++) {
        if (t % 4096 == 0 && !tf_watch_done(surface->watch, 0))
            return TF_CANCELLED;
        tf_shape shape = tf_shape_of(surface, t);
        double quality = tf_shape_quality(&shape);
        *least = fmin(*least, quality);
        sum += quality;
    }
    *mean = surface->triangles > 0 ? sum / surface->triangles : 1;
    return TF_OK;
}

//: Measure how far the shape has changed
static tf_status measure_distance(tf_remesher *remesher, double fine)
{
    const tf_adaptive_surface *before = remesher->original.surface;
    const tf_adaptive_surface *after = remesher->surface;
    tf_watch *watch = after->watch;
    tf_original now = {0};
    tf_watch_stage(watch, "measuring",
                   (size_t)before->triangles + (size_t)after->triangles);
    tf_status status = tf_original_begin(&now, after, watch);
    if (status == TF_OK) {
        tf_reach forth =
            tf_surface_reach(&remesher->original, after, fine, NULL, watch);
        tf_reach back = tf_surface_reach(&now, before, fine, NULL, watch);
        remesher->report.distance =
            fmax(forth.least, back.least) / after->scale;
        remesher->report.most_distance =
            fmax(forth.most, back.most) / after->scale;
    }
    tf_original_free(&now);
    return status == TF_OK && tf_watch_cancelled(watch) ? TF_CANCELLED : status;
}

//: Find the cosine of an angle
/// Rounded to 40 bits, so that it is the same with every mathematical library.
static double cosine_of(double degrees)
{
    const double pi = 3.14159265358979323846;
    return ldexp(round(ldexp(cos(degrees * pi / 180), 40)), -40);
}

//: Begin with the original
/// Makes a draft of a surface, which stays the original.
static tf_status begin(tf_remesher *remesher,
                       const tf_adaptive_surface *surface,
                       const tf_remesh_options *options, tf_watch *watch)
{
    tf_sharp_edges *sharp = &remesher->sharp_before;
    const tf_sharpness sharpness = {
        cosine_of(options->crease),
        options->error > 0 ? options->error * surface->scale : INFINITY,
        options->keeps, options->keep};
    tf_watch_stage(watch, "copying", 0);
    tf_status status = tf_draft_begin(remesher->surface, surface, watch);
    if (status == TF_OK)
        status = tf_original_begin(&remesher->original, surface, watch);
    if (status == TF_OK)
        status = tf_sharp_edges_find(sharp, surface, &sharpness, watch);
    if (status != TF_OK)
        return status;
    return tf_sharp_edges_copy(&remesher->sharp, sharp) &&
                   tf_trace_begin(&remesher->trace, &remesher->original, sharp)
               ? TF_OK
               : TF_OUT_OF_MEMORY;
}

//: Remesh from the original on
static tf_status do_round(tf_remesher *remesher)
{
    tf_status status = tf_remesh_round(remesher);
    remesher->report.rounds++;
    return status == TF_OK ? tf_remesher_compact(remesher) : status;
}

static tf_status do_rounds(tf_remesher *remesher, int rounds)
{
    tf_status status = TF_OK;
    for (int i = 0; i < rounds && status == TF_OK; i++)
        status = do_round(remesher);
    return status;
}

//: Remesh within a distance
/// Splits edges until nothing is further apart than that.
static tf_status refine(tf_remesher *remesher, tf_sizes *sizes, double error,
                        double most)
{
    tf_status status = TF_OK;
    for (int i = 0; i < MOST_REFINEMENTS && status == TF_OK && most > error;
         i++) {
        status = tf_remesh_pass(remesher, TF_SPLIT);
        if (status == TF_OK)
            status = tf_remesher_compact(remesher);
        if (status == TF_OK)
            status = tf_sizes_adapt(sizes, remesher, error, true, &most);
    }
    return status == TF_OK && most > error ? TF_BAD_OPTION : status;
}

/// In the first half of the rounds sizes shrink and grow, and then they only
/// shrink.
static tf_status do_bounded_rounds(tf_remesher *remesher, tf_sizes *sizes,
                                   int rounds, double error)
{
    double most = INFINITY;
    tf_status status = TF_OK;
    for (int i = 0; i < rounds && status == TF_OK; i++) {
        status = do_round(remesher);
        if (status == TF_OK)
            status =
                tf_sizes_adapt(sizes, remesher, error, 2 * i >= rounds, &most);
    }
    return status == TF_OK ? refine(remesher, sizes, error, most) : status;
}

//: Remesh and measure
static tf_status do_all(tf_remesher *remesher, tf_sizes *sizes,
                        const tf_remesh_options *options)
{
    tf_remesh_report *report = &remesher->report;
    // What is computed of a distance is a little less than it is.
    double error = options->error * remesher->surface->scale * (1 - 1e-9);
    tf_status status = tf_remesher_compact(remesher);
    if (status == TF_OK)
        status = measure_quality(remesher->surface, &report->least_before,
                                 &report->mean_before);
    if (status == TF_OK)
        status = error > 0 ? do_bounded_rounds(remesher, sizes, options->rounds,
                                               error)
                           : do_rounds(remesher, options->rounds);
    if (status == TF_OK)
        status = measure_quality(remesher->surface, &report->least_after,
                                 &report->mean_after);
    double fine = error > 0 ? error / 100 : 1e-4 * remesher->edge;
    if (status == TF_OK)
        status = measure_distance(remesher, fine);
    // A bound has been kept, however coarsely that is measured now.
    if (status == TF_OK && error > 0)
        report->most_distance = fmin(report->most_distance, options->error);
    return status == TF_OK
               ? tf_corner_origins_find(remesher, &remesher->corner_origin)
               : status;
}

//: Check lengths
/// The longest that a vertex wants.
static double longest_of(const tf_remesh_options *options,
                         const tf_adaptive_surface *surface)
{
    double longest = 0;
    for (int v = 0; v < surface->vertices; v++)
        longest = fmax(longest, options->lengths[v]);
    return longest;
}

/// The diagonal of the box around all vertices.
static double extent_of(const tf_adaptive_surface *surface)
{
    tf_aabb box = tf_aabb_empty();
    for (int v = 0; v < surface->vertices; v++)
        if (tf_first_corner(surface, v) != TF_NONE)
            tf_aabb_add(&box, tf_vertex_coordinates(surface, v));
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        double side = (box.high[k] - box.low[k]) * surface->scale;
        sum += side * side;
    }
    return sqrt(sum) / surface->scale;
}

/// Without a greatest length the lengths have it, or there is none.
static tf_status read_lengths(tf_remesh_options *own,
                              const tf_adaptive_surface *surface,
                              tf_error *error)
{
    if (!(own->error >= 0) || !isfinite(own->error) ||
        (own->error > 0 && own->error < 0x1p-36 * extent_of(surface)))
        return tf_fail_option(error, "error",
                              "0, or at least 2^-36 of the surface's extent",
                              own->error);
    for (int v = 0; own->lengths && v < surface->vertices; v++)
        if (!(own->lengths[v] > 0) || !isfinite(own->lengths[v]))
            return tf_fail_vertex_option(error, "lengths", "above 0", v,
                                         own->lengths[v]);
    if (own->edge == 0 && own->lengths)
        own->edge = longest_of(own, surface);
    else if (own->edge == 0 && own->error > 0 && surface->triangles > 0)
        own->edge = extent_of(surface);
    return tf_fail(error, TF_OK);
}

//: Check what is kept
/// Whether an edge, or a vertex twice, is in a surface.
static bool has_edge(const tf_adaptive_surface *surface, const int vertex[2])
{
    int a = vertex[0], b = vertex[1], count = surface->vertices;
    if (a < 0 || b < 0 || a >= count || b >= count)
        return false;
    if (a == b)
        return tf_first_corner(surface, a) != TF_NONE;
    return tf_find_edge(surface, a, b) != TF_NONE ||
           tf_find_edge(surface, b, a) != TF_NONE;
}

static tf_status check_sharp(const tf_remesh_options *options,
                             const tf_adaptive_surface *surface,
                             tf_error *error)
{
    if (!(options->crease > 0 && options->crease <= 180))
        return tf_fail_option(error, "crease", "above 0, at most 180",
                              options->crease);
    if (options->keeps < 0)
        return tf_fail_option(error, "keeps", "0 or more", options->keeps);
    for (int i = 0; i < options->keeps; i++)
        if (!has_edge(surface, options->keep + 2 * (ptrdiff_t)i))
            return tf_fail_option(error, "keep", "edges of the surface", i);
    return tf_fail(error, TF_OK);
}

//: Check how to remesh
static tf_status read_options(tf_remesh_options *own,
                              const tf_remesh_options *options,
                              tf_adaptive_surface *surface, tf_error *error)
{
    size_t first = offsetof(tf_remesh_options, context) + sizeof own->context;
    tf_fail(error, TF_OK);
    if (!tf_environment_is_ieee())
        return tf_fail(error, TF_BAD_ENVIRONMENT);
    tf_status status = tf_options_read(own, sizeof *own, options, first, error);
    if (own->rounds == 0)
        own->rounds = own->error > 0 ? USUAL_BOUNDED_ROUNDS : USUAL_ROUNDS;
    own->crease = own->crease == 0 ? USUAL_CREASE : own->crease;
    tf_choose_scale(surface);
    if (status == TF_OK)
        status = tf_check_coordinates(surface, TF_MOST_FOR_LENGTHS, error);
    if (status == TF_OK)
        status = read_lengths(own, surface, error);
    if (status == TF_OK)
        status = tf_check_target(surface, own->edge, error);
    return status == TF_OK ? check_sharp(own, surface, error) : status;
}

//: Begin with sizes
static bool begin_sizes(tf_sizes *sizes, tf_remesher *remesher,
                        const tf_remesh_options *options)
{
    if (options->error > 0)
        return tf_sizes_begin_for(sizes, remesher,
                                  options->error * remesher->surface->scale);
    return !options->lengths ||
           tf_sizes_begin(sizes, remesher, options->lengths);
}

//: Remesh a draft
/// The surface takes over what the remesher has.
static void accept(tf_remesher *remesher, tf_adaptive_surface *surface)
{
    tf_adaptive_lent *lent = &surface->lent;
    tf_draft_accept(remesher->surface, surface);
    tf_buffer_free(&lent->origin);
    tf_buffer_free(&lent->corner_origin);
    lent->origin = remesher->trace.origin;
    lent->corner_origin = remesher->corner_origin;
    lent->has_origins = true;
    remesher->trace.origin = remesher->corner_origin = (tf_buffer){0};
    *(tf_remesh_report *)lent->remesh_report.data = remesher->report;
}

static tf_status remesh(tf_adaptive_surface *surface,
                        const tf_remesh_options *options, tf_watch *watch)
{
    tf_adaptive_surface draft = {0};
    tf_sizes sizes = {0};
    tf_remesher remesher = {.surface = &draft,
                            .policy = &tf_keep_shape,
                            .edge = options->edge * surface->scale};
    tf_status status = tf_buffer_extend(&surface->lent.remesh_report, 1,
                                        sizeof(tf_remesh_report))
                           ? begin(&remesher, surface, options, watch)
                           : TF_OUT_OF_MEMORY;
    if (status == TF_OK && !begin_sizes(&sizes, &remesher, options))
        status = tf_watch_failure(watch);
    if (status == TF_OK)
        status = do_all(&remesher, &sizes, options);
    if (status == TF_OK)
        accept(&remesher, surface);
    tf_sizes_free(&sizes);
    tf_remesher_free(&remesher);
    tf_draft_free(&draft);
    return status;
}

//: Remesh a surface
tf_status tf_adaptive_remesh(tf_adaptive_surface *surface,
                             const tf_remesh_options *options,
                             const tf_remesh_report **report, tf_error *error)
{
    TF_REQUIRE(surface && options);
    tf_remesh_options own = {0};
    tf_status status = read_options(&own, options, surface, error);
    if (status != TF_OK)
        return status;
    tf_watch watch;
    status = remesh(surface, &own,
                    tf_watch_begin(&watch, own.progress, own.context));
    if (status == TF_OK && report)
        *report = surface->lent.remesh_report.data;
    return status == TF_BAD_OPTION
               ? tf_fail_option(error, "error", "large enough to be kept",
                                own.error)
               : tf_fail(error, status);
}
