//: Declare the clamped arithmetic
#pragma once

#include "base/api.h"

#include "arithmetic/arithmetic.h"

/// @addtogroup arithmetics
/// @{

/// Rounded determinants with error bounds; inside the bound the sign is
/// unknown.  Any finite doubles.  Sound: a query answers TF_UNDECIDED, never
/// TF_APART, where the unknown signs leave a contact open.
TF_API extern const tf_arithmetic tf_clamped;

/// @}
