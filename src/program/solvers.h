//: Declare the names of solvers
#pragma once

#include "response/zone.h"

/// The names that tf_solver_named accepts, for help and messages.
#define TF_SOLVER_NAMES                                                        \
    "gauss-seidel, conjugate-residuals, minres or normal-residuals"

/// The solver of that name; NULL if there is none.
const tf_zone_solver *tf_solver_named(const char *name);
