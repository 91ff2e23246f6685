//: Declare conjugate residuals
#pragma once

#include "base/api.h"
#include "response/zone.h"

/// @addtogroup study
/// @{

/// Takes constraints as equations, so that it also holds together elements that
/// would move apart anyway, and leaves out friction.  Each iteration makes the
/// residual as short as the directions so far allow.  Constraints that repeat
/// or contradict each other do no harm: the sum of the squares of what
/// constraints lack becomes least.  Method: Stiefel 1955.
TF_API extern const tf_zone_solver tf_conjugate_residuals;

/// @}
