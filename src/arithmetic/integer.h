//: Declare the integer arithmetics
#pragma once

#include "base/api.h"

#include "arithmetic/arithmetic.h"

/// @addtogroup study
/// @{

/// Exact signs in 64-bit integers: integer coordinates below 2^19 in space,
/// 2^30 in the plane.
TF_API extern const tf_arithmetic tf_integer64;

/// Exact signs in 128-bit integers: integer coordinates below 2^40 in space,
/// 2^53 in the plane.
TF_API extern const tf_arithmetic tf_integer128;

/// @}
