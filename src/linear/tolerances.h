//: Declare the tolerances
#pragma once

#include "base/api.h"

/// @addtogroup study
/// @{

/// When elements that a rounded root brings into one plane (in the plane: onto
/// one line) touch.  Both are finite and at least 0; larger ones never lose a
/// contact.  With both zero, the default, the elements touch at a root if the
/// rounded barycentric coordinates there are at least 0, whatever height
/// rounding has left between them; at other times they have to be at distance
/// 0.
///
/// See Bridson, Fedkiw and Anderson, "Robust treatment of collisions, contact
/// and friction for cloth animation" (2002), section 7, and for `barycentric`
/// Provot, "Collision and self-collision handling in cloth model" (1997).
typedef struct tf_tolerances {
    double distance; ///< elements at most this far apart touch, at a root, at
                     ///< an extremum of the polynomial, and at the ends of the
                     ///< step; in units of length; 1e-6 is usual in scenes of
                     ///< size 1
    double barycentric; ///< at a root, barycentric coordinates may be below 0
                        ///< by this; a pure number
} tf_tolerances;

/// @}
