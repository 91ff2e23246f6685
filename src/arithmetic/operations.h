//: Declare the signs
#pragma once

#include "arithmetic/arithmetic.h"
#include "arithmetic/differences.h"

#include <stdbool.h>
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

//: Declare what an arithmetic does
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

/// Whether `arithmetic` can hold the coordinate `x` of a scene with `axes`
/// axes.
bool tf_arithmetic_holds(const tf_arithmetic *arithmetic, int axes, double x);
