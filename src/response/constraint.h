//: Declare constraints
#pragma once

#include "base/api.h"

/// @addtogroup response Response
/// @{

/// What a contact demands of the displacements d of its vertices: the
/// inequality
///
///     sum over i of coefficient[i] (normal . d_i) >= bound.
///
/// Its left side is the gap change, by how much the displacements widen the gap
/// between the two elements along the normal.  The impulse pushes along the
/// same vector: it adds
///
///     impulse inverse_mass_i coefficient[i] normal
///
/// to the displacement of vertex i.
typedef struct tf_constraint {
    int vertex[4]; ///< those that the constraint pushes, followed by -1s
    double coefficient[4]; ///< not 0; the coefficients of the first element's
                           ///< vertices add up to +1, the others to -1
    double normal[3];      ///< of length 1; `normal[2]` is 0 in the plane
    double bound;          ///< a length; at least 0, except where elements may
                           ///< approach each other down to the thickness
    double impulse;        ///< at least 0, in units of mass times length
    double friction[3];    ///< an impulse across the normal, which pushes the
                           ///< vertices in the same proportions
} tf_constraint;

/// @}
