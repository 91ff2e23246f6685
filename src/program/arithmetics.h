//: Declare the names of arithmetics
#pragma once

#include "arithmetic/arithmetic.h"

#include <stdbool.h>

/// The names that tf_arithmetic_named accepts, for help and messages.
#define TF_ARITHMETIC_NAMES                                                    \
    "exact, clamped, report, perturbed, integer64 or integer128"

/// The arithmetic of that name; NULL if there is none.
const tf_arithmetic *tf_arithmetic_named(const char *name);

//: Declare what an arithmetic can hold
/// Whether an arithmetic can hold a coordinate of a scene with that many axes.
bool tf_arithmetic_fits(const tf_arithmetic *arithmetic, int axes, double x);

/// What is wrong where it cannot, as a format for the coordinate, the name of
/// the arithmetic and the bits that it holds.
#define TF_OUT_OF_RANGE_FAULT                                                  \
    "the coordinate %.17g is out of range: %s holds integers below 2^%d in "   \
    "absolute value; use --arithmetic exact"
