//: Declare the clamped arithmetic
#ifndef TF_ARITHMETIC_CLAMPED_H
#define TF_ARITHMETIC_CLAMPED_H

#include "arithmetic/differences.h"

//: Declare the estimate of a determinant
/// A determinant in rounded arithmetic.  If |number| > bound its sign is the
/// sign of the true determinant; if both are zero the true one is exactly zero;
/// otherwise, NaN and infinity included, nothing is known.
typedef struct tf_estimate {
    double number, bound;
} tf_estimate;

tf_estimate tf_differences_estimate(const tf_differences *differences);

//: Declare the two clamped arithmetics
/// Rounded determinants with their error bounds; inside the bound the sign is
/// TF_UNKNOWN.  Sound: what it knows is true, and a query answers
/// TF_UNDECIDED, never TF_APART, where the unknown signs leave a contact open.
extern const tf_arithmetic tf_clamped;

/// The rule of Brochu and Bridson's report: inside the bound the sign counts
/// as TF_ZERO.  Kept for teaching; unsound, it calls some real contacts apart.
extern const tf_arithmetic tf_report;

//: Close the clamped arithmetic
#endif
