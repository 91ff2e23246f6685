//: Detect by vectors
#include "fast/detect.h"

#include "base/require.h"
#include "fast/vectorized.h"
#include "surface/detect.h"

tf_status tf_surface_detect(tf_surface *surface, const tf_motion *motion,
                            const tf_detect_options *options,
                            tf_contacts *found, tf_error *error)
{
    TF_REQUIRE(surface && motion && found);
    tf_detect_options own;
    tf_status status = tf_detect_options_read(&own, options, error);
    if (status != TF_OK)
        return status;
    if (!own.narrow_phase)
        own.narrow_phase = &tf_vectorized;
    return tf_detect(surface, motion, &own, found, error);
}
