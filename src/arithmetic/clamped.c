//: Include what the clamped arithmetic needs
#include "arithmetic/clamped.h"

#include "arithmetic/filter.h"
#include "arithmetic/functions.h"

#include <math.h>

//: Clamp a sign
static tf_sign clamped_sign(const tf_differences *differences)
{
    tf_estimate estimate = tf_differences_estimate(differences);
    if (estimate.number > estimate.bound)
        return TF_POSITIVE;
    if (-estimate.number > estimate.bound)
        return TF_NEGATIVE;
    return estimate.bound == 0 ? TF_ZERO : TF_UNKNOWN;
}

//: Give a value its radius
static tf_value clamped_value(const tf_differences *differences)
{
    tf_estimate estimate = tf_differences_estimate(differences);

    // By the definition of tf_value the rounding of the last addition need not
    // be part of the radius.  The 4 u cover it anyway, along with the roundings
    // when a caller computes number - radius or number + radius, so callers
    // need not allow for any of them.
    const double u = DBL_EPSILON / 2;
    return (tf_value){.number = estimate.number,
                      .radius = estimate.bound * (1 + 4 * u) +
                                4 * u * fabs(estimate.number)};
}

//: Name the clamped arithmetic
const tf_arithmetic tf_clamped = {
    .name = "clamped", .sign = clamped_sign, .value = clamped_value};
