//: Declare moving vertices
#pragma once

#include "base/api.h"

/// @addtogroup motion Moving vertices
/// @{

/// The vertices of a scene in one time step, borrowed from the caller.  Each
/// moves in a straight line from its start to its end.
///
/// Coordinates are in any one unit of length, three a vertex in space (x, y,
/// z), two in the plane (x, y); they are finite.  The index of a vertex is its
/// place in the list, and the answers depend on it: an element is swept vertex
/// by vertex, in the order of its vertices' indices, so that neighbors share
/// the walls of their sweeps.  Give a vertex the same index in all queries.
typedef struct tf_motion {
    int axes;            ///< 3 in space, 2 in the plane
    int vertices;        ///< how many
    const double *start; ///< coordinates at t = 0
    const double *end;   ///< coordinates at t = 1
} tf_motion;

/// @}
