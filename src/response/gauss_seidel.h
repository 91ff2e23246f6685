//: Declare projected Gauss-Seidel
#pragma once

#include "base/api.h"
#include "response/zone.h"

/// @addtogroup response
/// @{

/// Visits one row after another, sweep by sweep, and sets its impulse to the
/// least one, 0 or more, that satisfies it.  Applies friction.  A row that has
/// been visited is left alone as long as its vertices do not move or, without
/// friction, as long as it is off by no more than 1/100 of the largest
/// violation: that by the proposal, for rows that were solved before, and that
/// at the beginning, for the others.  Stops when a sweep changes no parting by
/// more.  If there is no friction, all bounds are 0, and the scripted vertices
/// are at rest, no sweep raises the kinetic energy.
TF_API extern const tf_zone_solver tf_gauss_seidel;

/// @}
