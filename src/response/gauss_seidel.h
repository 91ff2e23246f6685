//: Declare projected Gauss-Seidel
#pragma once

#include "base/api.h"
#include "response/zone.h"

/// @addtogroup response
/// @{

/// Visits one row after another, sweep by sweep, and sets its impulse to the
/// least one, 0 or more, that satisfies it.  Applies friction.  Skips a row as
/// long as its vertices do not move, and stops when a sweep changes no parting
/// by more than 1/100 of the largest violation among the rows that were not
/// solved before.  If there is no friction, all bounds are 0, and the vertices
/// that cannot be moved are at rest, no sweep raises the kinetic energy.
TF_API extern const tf_zone_solver tf_gauss_seidel;

/// @}
