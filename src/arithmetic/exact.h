//: Declare the exact arithmetic
#ifndef TF_ARITHMETIC_EXACT_H
#define TF_ARITHMETIC_EXACT_H

#include "arithmetic/differences.h"

/// Exact signs of all finite doubles, subnormal and huge ones mixed.  Adaptive:
/// a rounded determinant with its error bound, then an expansion, then a sum of
/// products in an accumulator as wide as the range of a double demands.
extern const tf_arithmetic tf_exact;

#endif
