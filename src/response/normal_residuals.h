//: Declare conjugate gradients on the normal equations
#pragma once

#include "base/api.h"
#include "response/zone.h"

/// @addtogroup response
/// @{

/// Takes rows for equations, as tf_conjugate_residuals does, and makes the sum
/// of the squares of what they are short of least, by conjugate gradients
/// (CGNR).  Two products with the matrix an iteration, and the square of its
/// condition: many iterations.  Method: Hestenes and Stiefel 1952, section 10.
TF_API extern const tf_zone_solver tf_normal_residuals;

/// @}
