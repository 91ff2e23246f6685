//: Declare the names of arithmetics
#pragma once

#include "arithmetic/arithmetic.h"
#include "files/choice.h"

#include <stdbool.h>

/// The arithmetics by their names.
extern const tf_choice tf_arithmetics[];

//: Declare what an arithmetic can hold
/// Whether an arithmetic can hold a coordinate of a scene with that many axes.
bool tf_arithmetic_fits(const tf_arithmetic *arithmetic, int axes, double x);

/// What is wrong where it cannot, as a format for the coordinate, the name of
/// the arithmetic and the bits that it holds.
#define TF_OUT_OF_RANGE_FAULT                                                  \
    "the coordinate %.17g is out of range: %s holds integers below 2^%d in "   \
    "absolute value; use --arithmetic exact"
