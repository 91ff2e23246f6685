// The test of solvers of zones that may be cancelled.
#ifndef SUPPORT_LONG_SOLVES_H
#define SUPPORT_LONG_SOLVES_H

#include "response/zone.h"

/// What is wrong with how a solver asks whether to go on in a zone of thousands
/// of constraints, and ends if it is not to; NULL if nothing is.
/// @param least how many units of work it notes for each constraint, at least
const char *long_solve_fault(const tf_zone_solver *solver, size_t least);

#endif
