//: Declare the exact arithmetic
#pragma once

#include "base/api.h"

#include "arithmetic/arithmetic.h"

/// @addtogroup arithmetics
/// @{

/// Exact signs for any finite doubles, subnormal and huge ones mixed.  It
/// adapts: a rounded determinant with its error bound decides most signs, one
/// of integers most others, where the coordinates lie on a grid; a sum of
/// products in a superaccumulator, as wide as the range of a double demands,
/// decides the rest.
TF_API extern const tf_arithmetic tf_exact;

/// @}
