//: Include what detection needs
#include "surface/detect.h"

#include "arithmetic/exact.h"
#include "arithmetic/functions.h"
#include "base/require.h"
#include "surface/pairs.h"
#include "surface/state.h"

#include <stdbool.h>
#include <stddef.h>

//: Check that an arithmetic can hold all positions
static tf_status check_range(const tf_surface *surface, const tf_pair_job *of,
                             tf_flaw *flaw)
{
    int axes = surface->axes;
    if (tf_arithmetic_bits(of->arithmetic, axes) == 0)
        return TF_OK;
    for (int v = 0; v < surface->vertices; v++)
        for (int k = 0; k < axes; k++) {
            size_t place = (size_t)axes * (size_t)v + (size_t)k;
            if (tf_arithmetic_holds(of->arithmetic, axes,
                                    of->motion->start[place]) &&
                tf_arithmetic_holds(of->arithmetic, axes,
                                    of->motion->end[place]))
                continue;
            *flaw = (tf_flaw){TF_VERTEX, v, v};
            return TF_OUT_OF_RANGE;
        }
    return TF_OK;
}

//: Detect the contacts of a surface
static tf_status detect(tf_surface *surface, tf_pair_job *of,
                        const tf_parallel *parallel, tf_contacts *found,
                        tf_flaw *flaw)
{
    tf_status status = tf_surface_move(surface, of->motion, parallel, flaw);
    if (status == TF_OK)
        status = check_range(surface, of, flaw);
    if (status != TF_OK)
        return status;
    return tf_pairs_find(surface, of, parallel, found);
}

//: Detect with the usual choices
tf_status tf_surface_detect(tf_surface *surface, const tf_motion *motion,
                            const tf_detect_options *detection,
                            tf_contacts *found, tf_flaw *flaw)
{
    TF_REQUIRE(surface && motion && found);
    static const tf_detect_options usual;
    if (!detection)
        detection = &usual;
    tf_pair_job of = {
        .surface = surface,
        .motion = motion,
        .arithmetic = detection->arithmetic ? detection->arithmetic : &tf_exact,
        .narrow_phase =
            detection->narrow_phase ? detection->narrow_phase : &tf_reference,
        .selection = detection->selection};
    tf_flaw unused;
    return detect(surface, &of, detection->parallel, found,
                  flaw ? flaw : &unused);
}
