//: Declare minimal residuals
#pragma once

#include "base/api.h"
#include "response/zone.h"

/// @addtogroup study
/// @{

/// Takes constraints as equations, as tf_conjugate_residuals does, and makes
/// the same residual least, but by the recurrences of Lanczos and by rotations,
/// which also work for matrices that are not semidefinite.  Method: Paige and
/// Saunders 1975 (MINRES).
TF_API extern const tf_zone_solver tf_minres;

/// @}
