//: Declare projected Gauss-Seidel
#pragma once

#include "base/api.h"
#include "response/zone.h"

/// @addtogroup response
/// @{

/// Visits one row after another, sweep by sweep, and sets its impulse to the
/// least one, 0 or more, that satisfies it; with friction.  Rows are skipped as
/// long as their vertices do not move, and it stops when a sweep changes no
/// parting by more than 1/100 of the largest violation among the rows that were
/// not solved before.  Where all bounds are 0 and what cannot be moved rests, no
/// sweep raises the kinetic energy.
TF_API extern const tf_zone_solver tf_gauss_seidel;

/// @}
