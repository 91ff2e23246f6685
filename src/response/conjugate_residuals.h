//: Declare conjugate residuals
#pragma once

#include "base/api.h"
#include "response/zone.h"

/// @addtogroup response
/// @{

/// Takes rows for equations, so that elements that would part anyway are held
/// together, and knows no friction.  Each iteration makes the residual as small
/// as the directions so far allow.  Rows that contradict each other, or repeat,
/// do no harm: the squares of what they are short of get least.  Method: Stiefel
/// 1955.
TF_API extern const tf_zone_solver tf_conjugate_residuals;

/// @}
