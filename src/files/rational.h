//: Declare how to round a rational
#pragma once

#include <stdbool.h>
#include <stddef.h>

//: Declare a numeral
/// A decimal integer of any length, as text.
typedef struct tf_numeral {
    const char *digit; ///< the first that is not a leading zero; borrowed
    size_t count;      ///< digits from there; 0: the integer is zero
    bool negative;
} tf_numeral;

/// Read the integer, signed or not, that starts at *text and step *text behind
/// it.  Returns false, with *text unchanged, if no integer starts there.
bool tf_numeral_read(const char **text, tf_numeral *numeral);

//: Declare the rounding of a quotient
typedef enum tf_rounding {
    TF_ROUNDING_FAILED = 0, ///< out of memory
    TF_ROUNDING_EXACT,      ///< the quotient is a double
    TF_ROUNDING_NEAREST,    ///< it is not: the nearest double, ties to even
    TF_ROUNDING_OVERFLOW,   ///< the nearest would be an infinity
} tf_rounding;

/// The double nearest to a quotient, rounded once, subnormals included.
/// `divisor` must not be zero; both may be negative.  *nearest is set where
/// the quotient is exact or rounded.  The time grows with the square of the
/// number of digits.
tf_rounding tf_rational_round(const tf_numeral *dividend,
                              const tf_numeral *divisor, double *nearest);
