//: Declare the signs
#pragma once

#include "geometry/vector.h"

#include <stdint.h>

/// The sign of a determinant.
typedef enum tf_sign {
    TF_NEGATIVE = -1,
    TF_ZERO = 0, ///< certainly zero (but see tf_published)
    TF_POSITIVE = 1,
    TF_UNKNOWN = 2, ///< any of the three
} tf_sign;

//: Declare the value of a determinant
/// A real number v with |v - number 2^exponent| <= (radius + u |number|)
/// 2^exponent, u = 2^-53: besides the rounding of `number`, at most `radius`
/// off.  A zero `number` with a zero `radius` is exactly zero.
typedef struct tf_value {
    double number; ///< NaN or infinite: nothing is known
    double radius; ///< >= 0, or NaN: nothing is known
    int exponent;
    /// Zeros, except where the value is infinitely small: then it is `number`
    /// 2^exponent times the infinitesimals named here.  Of two values the one
    /// with the later order (by the first entry that differs) is infinitely
    /// smaller.
    int64_t order[TF_AXES];
} tf_value;
