//: Declare what changes the topology of a surface
#pragma once

#include "base/api.h"
#include "base/status.h"
#include "surgery/adaptive.h"
#include "surgery/outcome.h"

/// @addtogroup adaptive
/// @{

/// Joins two edges by a tube.  The two triangles on each of them are removed,
/// and eight new ones lead around from the one hole to the other.
///
/// This operation and the others below are all or nothing, too, and what is
/// left is embedded.  They are not motions of the surface only: besides, what
/// is in a ball (here that between the four triangles and the tube), or inside
/// of a part that is dropped, changes sides.  Nothing else does, and no part of
/// the surface is in there.  This is exact; what might be otherwise is refused.
///
/// @param surface the surface
/// @param first the ends of an edge that has two triangles
/// @param second the ends of another one, far enough along the surface that the
///     four triangles have eight vertices, and no edge leads from two of them
///     to the two others
/// @param[out] outcome what became of it
/// @return as for tf_adaptive_split
TF_API tf_status tf_adaptive_merge(tf_adaptive_surface *surface,
                                   const int first[2], const int second[2],
                                   tf_outcome *outcome);

//: Declare how a surface is pinched
/// Cuts a surface along three edges and closes both holes with a triangle.
///
/// Of the vertices there are two each then: the triangles to the left of the
/// edges, seen from outside, get a new one, which moves straight to a place of
/// its own.
///
/// @param surface the surface
/// @param loop three vertices, with an edge from each to the next, that are not
///     those of a triangle, and not on the boundary
/// @param place where the new vertices end, three coordinates each, not among
///     those that the surface lends
/// @param[out] vertex the numbers of the new vertices; set only if it is
///     committed
/// @param[out] outcome what became of it
/// @return as for tf_adaptive_split
TF_API tf_status tf_adaptive_pinch(tf_adaptive_surface *surface,
                                   const int loop[3], const double place[9],
                                   int vertex[3], tf_outcome *outcome);

//: Declare how a part of a surface is dropped
/// Removes the part of a surface that is connected with a vertex, unless it has
/// a boundary (TF_IMPOSSIBLE) or another part is inside of it
/// (TF_PASSED_VERTEX).
/// @param surface the surface
/// @param vertex the number of a vertex of that part
/// @param[out] outcome what became of it
/// @return as for tf_adaptive_split
TF_API tf_status tf_adaptive_drop(tf_adaptive_surface *surface, int vertex,
                                  tf_outcome *outcome);

/// @}
