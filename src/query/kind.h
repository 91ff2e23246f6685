//: Declare the kinds of queries
#pragma once

#include "base/api.h"

/// @addtogroup narrow_phases Narrow phases
/// @{

/// Which two elements a query is about.
typedef enum tf_kind {
    TF_NO_KIND = 0,    ///< no query
    TF_POINT_EDGE,     ///< in the plane; vertices: point, edge
    TF_POINT_TRIANGLE, ///< in space; vertices: point, triangle
    TF_EDGE_EDGE,      ///< in space; vertices: first edge, second edge
} tf_kind;

/// @}
