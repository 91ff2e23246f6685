//: Declare the names of arithmetics
#ifndef TF_PROGRAM_ARITHMETICS_H
#define TF_PROGRAM_ARITHMETICS_H

#include "arithmetic/differences.h"

/// The names that tf_arithmetic_named knows, for help and messages.
#define TF_ARITHMETIC_NAMES                                                    \
    "exact, clamped, report, perturbed, integer64 or integer128"

/// The arithmetic of that name; NULL if there is none.
const tf_arithmetic *tf_arithmetic_named(const char *name);

#endif
