//: Declare how a surface is pinched
#pragma once

#include "base/api.h"
#include "base/status.h"
#include "surgery/adaptive.h"
#include "surgery/outcome.h"

/// @addtogroup adaptive
/// @{

/// Cuts a surface along three edges and closes both holes with a triangle.
///
/// Of the vertices there are two each then: the triangles to the left of the
/// edges, seen from outside, get a new one, which moves straight to a position
/// of its own.
///
/// @param surface the surface
/// @param loop three vertices, with an edge from each to the next, that are not
///     those of a triangle, and not on the boundary
/// @param position where the new vertices end, three coordinates each, not
///     among those that the surface lends
/// @param[out] vertex the numbers of the new vertices; set only if it is
///     committed
/// @param[out] outcome what became of it
/// @return as for tf_adaptive_split
TF_API tf_status tf_adaptive_pinch(tf_adaptive_surface *surface,
                                   const int loop[3], const double position[9],
                                   int vertex[3], tf_outcome *outcome);

/// @}
