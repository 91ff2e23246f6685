//: Declare projected Gauss-Seidel
#pragma once

#include "base/api.h"
#include "response/zone.h"

/// @addtogroup response
/// @{

/// Visits one row after another, sweep by sweep, and sets its impulse to the
/// least one, 0 or more, that satisfies it; with friction.  Rows that have been
/// visited are left alone as long as their vertices do not move or, without
/// friction, as they are off by no more than 1/100 of the largest violation
/// that there was: in rows that were solved before by the proposal, in the
/// others at first.  It stops when a sweep changes no parting by more than that.
/// Where all bounds are 0 and what cannot be moved rests, no sweep without
/// friction raises the kinetic energy.
TF_API extern const tf_zone_solver tf_gauss_seidel;

/// @}
