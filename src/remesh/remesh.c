//: Include what remeshing needs
#include "remesh/remesh.h"

#include "base/environment.h"
#include "base/require.h"
#include "remesh/keep_shape.h"
#include "remesh/measure.h"
#include "remesh/passes.h"

#include <limits.h>

enum {
    USUAL_ROUNDS = 5
};

//: Measure the quality of a surface
static void measure_quality(const tf_adaptive_surface *surface, double *least,
                            double *mean)
{
    double sum = 0;
    *least = 1;
    for (int t = 0; t < surface->triangles; t++) {
        tf_shape shape = tf_shape_of(surface, t);
        double quality = tf_shape_quality(&shape);
        *least = fmin(*least, quality);
        sum += quality;
    }
    *mean = sum / surface->triangles;
}

//: Measure how far the shape has changed
static tf_status measure_distance(tf_remesher *remesher)
{
    tf_original now = {0};
    tf_status status = TF_OUT_OF_MEMORY;
    if (tf_original_copy(&now, remesher->surface)) {
        remesher->report.distance =
            fmax(tf_original_farthest(&remesher->original, &now),
                 tf_original_farthest(&now, &remesher->original));
        status = TF_OK;
    }
    tf_original_free(&now);
    return status;
}

//: Remesh from the original on
static tf_status do_round(tf_remesher *remesher)
{
    tf_status status = tf_remesh_round(remesher);
    remesher->report.rounds++;
    return status == TF_OK ? tf_adaptive_compact(remesher->surface, NULL)
                           : status;
}

static tf_status do_rounds(tf_remesher *remesher)
{
    tf_remesh_report *report = &remesher->report;
    int rounds =
        remesher->options.rounds ? remesher->options.rounds : USUAL_ROUNDS;
    tf_status status = tf_adaptive_compact(remesher->surface, NULL);
    if (status == TF_OK &&
        !tf_original_copy(&remesher->original, remesher->surface))
        status = TF_OUT_OF_MEMORY;
    if (status != TF_OK)
        return status;
    measure_quality(remesher->surface, &report->least_before,
                    &report->mean_before);
    for (int i = 0; i < rounds && status == TF_OK; i++)
        status = do_round(remesher);
    if (status != TF_OK)
        return status;
    measure_quality(remesher->surface, &report->least_after,
                    &report->mean_after);
    return measure_distance(remesher);
}

//: Estimate how many triangles there will be
/// Equilateral ones with sides of that length, which have as much area as the
/// surface.
static double triangles_of(const tf_adaptive_surface *surface, double edge)
{
    double count = 0;
    for (int t = 0; t < surface->triangles; t++) {
        if (!tf_is_triangle(surface, t))
            continue;
        tf_shape shape = tf_shape_of(surface, t);
        for (int i = 0; i < 3; i++)
            shape.corner[i] = tf_vector_scaled(1 / edge, shape.corner[i]);
        count += tf_vector_length(tf_shape_normal(&shape)) * 2 / sqrt(3);
    }
    return count;
}

static bool is_possible(const tf_adaptive_surface *surface,
                        const tf_remesh_options *options)
{
    double edge = options->edge;
    return edge > 0 && isfinite(edge) && options->rounds >= 0 &&
           triangles_of(surface, edge) <= INT_MAX / 3.0;
}

//: Remesh a surface
tf_status tf_adaptive_remesh(tf_adaptive_surface *surface,
                             const tf_remesh_options *options,
                             tf_remesh_report *report)
{
    TF_REQUIRE(surface && options);
    if (!tf_environment_is_ieee())
        return TF_BAD_ENVIRONMENT;
    if (!is_possible(surface, options))
        return TF_BAD_OPTION;
    tf_remesher remesher = {
        .surface = surface, .policy = &tf_keep_shape, .options = *options};
    tf_status status = do_rounds(&remesher);
    if (report)
        *report = remesher.report;
    tf_remesher_free(&remesher);
    return status;
}
