//: Declare rows
#pragma once

#include "base/api.h"

/// @addtogroup response Response
/// @{

/// What a contact wants of the displacements d of its vertices: an inequality
///
///     sum over i of coefficient[i] (normal . d_i) >= bound,
///
/// whose left side is how far the two elements move apart along the normal.
/// The impulse pushes along the same vector: it adds impulse inverse_mass_i
/// coefficient[i] normal to the displacement of vertex i.
typedef struct tf_row {
    int vertex[4];         ///< those that the row pushes; behind them -1
    double coefficient[4]; ///< not 0; those of the first element's vertices sum
                           ///< to +1, those of the second's to -1
    double normal[3];      ///< of length 1; `normal[2]` is 0 in the plane
    double bound;          ///< at least 0, a length
    double impulse;        ///< at least 0, in units of mass times length
    double friction[3];    ///< the impulse across the normal; pushes as the
                           ///< other does
} tf_row;

/// @}
