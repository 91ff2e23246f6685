//: Declare how an edge is split
#pragma once

#include "base/api.h"
#include "base/status.h"
#include "surgery/adaptive.h"
#include "surgery/outcome.h"

/// @addtogroup adaptive
/// @{

/// Splits an edge in two, and each triangle on it, and moves the new vertex to
/// a position, which need not be on the edge.
///
/// @param surface the surface
/// @param a one end of the edge
/// @param b the other end
/// @param position three coordinates, not among those that the surface lends
/// @param[out] vertex the number of the new vertex; set only if it is committed
/// @param[out] outcome what became of it
/// @return TF_OK, also if it is refused; TF_NOT_FINITE; TF_BAD_INDEX if a number
///     is that of no vertex; TF_BAD_ENVIRONMENT; or TF_OUT_OF_MEMORY
TF_API tf_status tf_adaptive_split(tf_adaptive_surface *surface, int a, int b,
                                   const double position[3], int *vertex,
                                   tf_outcome *outcome);

/// @}
