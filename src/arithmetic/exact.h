//: Declare the exact arithmetic
#ifndef TF_ARITHMETIC_EXACT_H
#define TF_ARITHMETIC_EXACT_H

#include "arithmetic/differences.h"

/// Exact signs of all finite doubles, subnormal and huge ones mixed.  Adaptive:
/// a rounded determinant with its error bound, then a sum of products in an
/// accumulator as wide as the range of a double demands.
extern const tf_arithmetic tf_exact;

//: Declare the stages of an exact sign
/// What found an exact sign, the cheaper first.
typedef enum tf_stage {
    TF_BY_ESTIMATE = 0,
    TF_BY_ACCUMULATOR,
} tf_stage;

/// The sign that tf_exact finds, and by what: for whoever counts.
tf_sign tf_exact_sign(const tf_differences *differences, tf_stage *stage);

//: Close the exact arithmetic
#endif
