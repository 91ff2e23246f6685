//: Declare determinants on a grid
#pragma once

#include "arithmetic/operations.h"

enum {
    TF_FIXED_WORDS = 3,
    TF_FIXED_BITS = 62 ///< of a coordinate on the grid, besides its sign
};

/// The exact determinant of coordinates on a grid: an integer of three words,
/// in two's complement, least significant word first, times 2^exponent.
typedef struct tf_fixed {
    uint64_t word[TF_FIXED_WORDS];
    int exponent;
} tf_fixed;

//: Declare what fixed point does
/// Evaluates a determinant in integers, if the coordinates of each column are
/// multiples of one power of two, each less than 2^62 of them, and that power
/// is at least 2^-1022; false if not.
bool tf_fixed_determinant(const tf_differences *differences, tf_fixed *fixed);

/// The sign of the determinant.
tf_sign tf_fixed_sign(const tf_fixed *fixed);

/// The determinant, rounded to nearest once.
tf_value tf_fixed_value(const tf_fixed *fixed);
