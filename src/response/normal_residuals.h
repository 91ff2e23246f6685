//: Declare conjugate gradients on the normal equations
#pragma once

#include "base/api.h"
#include "response/zone.h"

/// @addtogroup study
/// @{

/// Takes constraints as equations, as tf_conjugate_residuals does, and makes
/// the sum of the squares of what constraints lack least, by conjugate
/// gradients on the normal equations (CGNR).  It needs many iterations, because
/// the condition of the matrix is squared, and each takes two products with the
/// matrix.  Method: Hestenes and Stiefel 1952, section 10.
TF_API extern const tf_zone_solver tf_normal_residuals;

/// @}
