//: Declare determinants on a grid
#pragma once

#include "arithmetic/operations.h"

enum {
    TF_GRID_BITS = 62 ///< of a coordinate on the grid, besides its sign
};

/// Finds the sign of a determinant in integers, if the coordinates of each
/// column are multiples of one power of two, less than 2^62 of them each, and
/// that power is at least 2^-1022; false if not.
bool tf_fixed_sign(const tf_differences *differences, tf_sign *sign);

/// The same for the determinant itself, rounded to nearest once:
/// *number 2^*exponent.
bool tf_fixed_value(const tf_differences *differences, double *number,
                    int *exponent);
