//: Declare determinants on a grid
#pragma once

#include "arithmetic/functions.h"

enum {
    TF_GRID_BITS = 62 ///< of a coordinate on the grid, besides its sign
};

/// Finds the exact sign of a determinant in integers of 192 bits.  That needs a
/// grid for each column: a power of two, at least 2^-1022, of which the
/// column's coordinates are multiples, by less than 2^62 in absolute value.
/// False if a column has none; *sign stays as it is then.
bool tf_fixed_sign(const tf_differences *differences, tf_sign *sign);

/// Finds the determinant in the same way, rounded to nearest once.
bool tf_fixed_value(const tf_differences *differences, tf_value *value);

//: Declare several values on one grid
/// The values that tf_arithmetic calls `six`, `six_signs` and `cross`, on a
/// grid for each axis that holds all of their events.  False if an axis has none.
bool tf_fixed_six(int start_count, const tf_event *const event[TF_SIX],
                  tf_value value[TF_SIX]);
bool tf_fixed_six_signs(int start_count, const tf_event *const event[TF_SIX],
                        tf_sign sign[TF_SIX]);
bool tf_fixed_cross(const tf_differences *edges, tf_value component[TF_AXES]);
