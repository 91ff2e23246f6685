//: Declare what changes an adaptive surface
#pragma once

#include "base/api.h"
#include "base/status.h"
#include "surgery/adaptive.h"
#include "surgery/outcome.h"

/// @addtogroup adaptive
/// @{

/// Splits an edge in two, and each triangle on it, and moves the new vertex to
/// a place, which need not be on the edge.
///
/// This operation and the others below are all or nothing.  One that is done is
/// a continuous motion of the surface, in which it never touches itself: so it
/// stays embedded, no part of it passes through another, and none is turned
/// inside out.  This is exact; what might not be such a motion is refused.
///
/// @param surface the surface
/// @param a one end of the edge
/// @param b the other end
/// @param place three coordinates, not among those that the surface lends
/// @param[out] vertex the number of the new vertex; set only if it is committed
/// @param[out] outcome what became of it
/// @return TF_OK, also if it is refused; TF_NOT_FINITE; TF_BAD_INDEX if a number
///     is that of no vertex; TF_BAD_ENVIRONMENT; or TF_OUT_OF_MEMORY
TF_API tf_status tf_adaptive_split(tf_adaptive_surface *surface, int a, int b,
                                   const double place[3], int *vertex,
                                   tf_outcome *outcome);

//: Declare how a vertex moves
/// Moves a vertex in a straight line.
/// @param surface the surface
/// @param vertex its number
/// @param place where it ends, three coordinates
/// @param[out] outcome what became of it
/// @return as for tf_adaptive_split
TF_API tf_status tf_adaptive_move(tf_adaptive_surface *surface, int vertex,
                                  const double place[3], tf_outcome *outcome);

//: Declare how an edge collapses
/// Moves a vertex along an edge to its other end, so that the triangles on the
/// edge vanish, and the vertex.
/// @param surface the surface
/// @param from the vertex that goes
/// @param to the vertex that stays where it is
/// @param[out] outcome what became of it
/// @return as for tf_adaptive_split
TF_API tf_status tf_adaptive_collapse(tf_adaptive_surface *surface, int from,
                                      int to, tf_outcome *outcome);

/// Moves one end of an edge to a place, and then collapses the edge into it.
/// @param surface the surface
/// @param from the vertex that goes
/// @param to the vertex that stays
/// @param place where it stays, three coordinates
/// @param[out] outcome what became of it: of the move, or of the collapse
/// @return as for tf_adaptive_split
TF_API tf_status tf_adaptive_collapse_to(tf_adaptive_surface *surface, int from,
                                         int to, const double place[3],
                                         tf_outcome *outcome);

//: Declare how an edge flips
/// Replaces the edge between two triangles by the other diagonal.
/// @param surface the surface
/// @param a one end of the edge
/// @param b the other end
/// @param[out] outcome what became of it
/// @return as for tf_adaptive_split
TF_API tf_status tf_adaptive_flip(tf_adaptive_surface *surface, int a, int b,
                                  tf_outcome *outcome);

/// @}
