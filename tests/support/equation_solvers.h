// The tests of a solver that takes the constraints of a zone for equations.
#ifndef SUPPORT_EQUATION_SOLVERS_H
#define SUPPORT_EQUATION_SOLVERS_H

#include "response/zone.h"
#include "support/support.h"

/// What to try; called by the function that is given to the suite.
void equation_solver_use(const tf_zone_solver *solver);

/// The tests, in a suite of this name.
Suite *equation_solver_suite(const char *name, void (*use)(void));

#endif
