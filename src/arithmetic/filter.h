//: Declare the estimate of a determinant
#pragma once

#include "arithmetic/differences.h"

/// A determinant in rounded arithmetic.  If |number| > bound its sign is the
/// sign of the true determinant; if both are zero the true one is exactly zero;
/// otherwise nothing is known, nor with a NaN or an infinite bound.
typedef struct tf_estimate {
    double number, bound;
} tf_estimate;

tf_estimate tf_differences_estimate(const tf_differences *differences);
