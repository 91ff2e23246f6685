//: Declare how an edge collapses
#pragma once

#include "base/api.h"
#include "base/status.h"
#include "surgery/adaptive.h"
#include "surgery/outcome.h"

/// @addtogroup adaptive
/// @{

/// Moves a vertex along an edge to its other end, so that the triangles on the
/// edge vanish, and the vertex.
/// @param surface the surface
/// @param from the vertex that goes
/// @param to the vertex that stays where it is
/// @param[out] outcome what became of it
/// @return as for tf_adaptive_split
TF_API tf_status tf_adaptive_collapse(tf_adaptive_surface *surface, int from,
                                      int to, tf_outcome *outcome);

//: Declare how an edge collapses to a position
/// Moves one end of an edge to a position, and then collapses the edge into it.
/// @param surface the surface
/// @param from the vertex that goes
/// @param to the vertex that stays
/// @param position where it stays, three coordinates
/// @param[out] outcome what became of it: of the move, or of the collapse
/// @return as for tf_adaptive_split
TF_API tf_status tf_adaptive_collapse_to(tf_adaptive_surface *surface, int from,
                                         int to, const double position[3],
                                         tf_outcome *outcome);

/// @}
