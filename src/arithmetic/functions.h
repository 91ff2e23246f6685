//: Declare what an arithmetic does
#pragma once

#include "arithmetic/differences.h"
#include "arithmetic/sign.h"

#include <math.h>
#include <stdbool.h>

enum {
    TF_SIX = 6 ///< the events of a pair in space
};

struct tf_arithmetic {
    const char *name;
    int bits[TF_AXES + 1]; ///< for 2 and 3 axes; see tf_arithmetic_bits
    bool needs_indices;    ///< every vertex must have one
    tf_sign (*sign)(const tf_differences *differences);
    tf_value (*value)(const tf_differences *differences);

    //: Declare how several values are found at once
    /// The values of six events in space, 2 to 4 of them at t = 0 and these
    /// first: value[i] is the determinant, without event i, of the differences
    /// within each time to the first event that is left.  False: find each by
    /// itself; NULL: always.
    bool (*six)(int start_count, const tf_event *const event[TF_SIX],
                tf_value value[TF_SIX]);

    /// The signs of the same six.  False or NULL as above.
    bool (*six_signs)(int start_count, const tf_event *const event[TF_SIX],
                      tf_sign sign[TF_SIX]);

    /// Those of these signs that an estimate proves; the others become
    /// TF_UNKNOWN.  NULL: it proves none.
    void (*six_estimates)(int start_count, const tf_event *const event[TF_SIX],
                          tf_sign sign[TF_SIX]);

    /// Those of the minors of two rows in space: the components of their cross
    /// product.  False or NULL as above.
    bool (*cross)(const tf_differences *rows, tf_value component[TF_AXES]);
};

//: Test whether an arithmetic holds a coordinate
/// Whether `arithmetic` can hold the coordinate `x` of a scene with `axes`
/// axes.
static inline bool tf_arithmetic_holds(const struct tf_arithmetic *arithmetic,
                                       int axes, double x)
{
    int bits = arithmetic->bits[axes];
    if (bits == 0)
        return isfinite(x);
    return fabs(x) < ldexp(1, bits) && x == trunc(x);
}
