//: Declare projected Gauss-Seidel
#pragma once

#include "base/api.h"
#include "response/zone.h"

/// @addtogroup response
/// @{

/// Visits one constraint after another, sweep by sweep, and sets its impulse to
/// the least one, 0 or more, that satisfies it.  Applies friction.  The
/// tolerance is 1/100 of the largest violation: that by the proposal, for
/// constraints that were solved before, and that at the beginning, for the
/// others.  A constraint that has been visited is left alone until a visit to a
/// constraint with a common vertex changes that constraint's gap by more than
/// the tolerance, and then, without friction, if it pushes too little by
/// no more than the tolerance and too much by no more than three.  Stops when a
/// sweep changes no gap, and no sliding, by more than the tolerance.  If
/// there is no friction, all bounds are 0, and the scripted vertices are at
/// rest, no sweep raises the kinetic energy.
TF_API extern const tf_zone_solver tf_gauss_seidel;

/// @}
