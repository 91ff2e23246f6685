//: Include what detection needs
#include "surface/detect.h"

#include "arithmetic/exact.h"
#include "arithmetic/functions.h"
#include "base/require.h"
#include "surface/pairs.h"
#include "surface/surface_memory.h"

#include <stdbool.h>
#include <stddef.h>

//: Check that an arithmetic can hold all positions
static tf_status check_range(const tf_surface *surface, const tf_pair_job *job,
                             tf_flaw *flaw)
{
    int axes = surface->axes;
    if (tf_arithmetic_bits(job->arithmetic, axes) == 0)
        return TF_OK;
    for (int v = 0; v < surface->vertices; v++)
        for (int k = 0; k < axes; k++) {
            size_t place = (size_t)axes * (size_t)v + (size_t)k;
            if (tf_arithmetic_holds(job->arithmetic, axes,
                                    job->motion->start[place]) &&
                tf_arithmetic_holds(job->arithmetic, axes,
                                    job->motion->end[place]))
                continue;
            *flaw = (tf_flaw){TF_VERTEX, v, v};
            return TF_OUT_OF_RANGE;
        }
    return TF_OK;
}

//: Detect the contacts of a surface
static tf_status detect(tf_surface *surface, tf_pair_job *job,
                        const tf_parallel *parallel, tf_contacts *found,
                        tf_flaw *flaw)
{
    tf_status status = tf_surface_move(surface, job->motion, parallel, flaw);
    if (status == TF_OK)
        status = check_range(surface, job, flaw);
    if (status != TF_OK)
        return status;
    return tf_pairs_find(surface, job, parallel, found);
}

//: Detect with the usual choices
tf_status tf_surface_detect(tf_surface *surface, const tf_motion *motion,
                            const tf_detect_options *options,
                            tf_contacts *found, tf_flaw *flaw)
{
    TF_REQUIRE(surface && motion && found);
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
    tf_flaw unused;
    return detect(surface, &job, options->parallel, found,
                  flaw ? flaw : &unused);
}
