//: Declare the integer arithmetics
#ifndef TF_ARITHMETIC_INTEGER_H
#define TF_ARITHMETIC_INTEGER_H

#include "arithmetic/differences.h"

/// Exact signs in 64-bit integers: integer coordinates below 2^19 in space,
/// 2^30 in the plane.
extern const tf_arithmetic tf_integer64;

/// Exact signs in 128-bit integers: integer coordinates below 2^40 in space,
/// 2^53 in the plane.
extern const tf_arithmetic tf_integer128;

#endif
