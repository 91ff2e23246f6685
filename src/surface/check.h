//: Declare the static check
#pragma once

#include "base/api.h"
#include "base/progress.h"
#include "surface/parallel.h"
#include "surface/surface.h"

#include <stddef.h>

/// @addtogroup surfaces
/// @{

/// How two elements at rest intersect.
typedef enum tf_crossing_kind {
    TF_NO_CROSSING = 0,       ///< they do not
    TF_EDGE_THROUGH_TRIANGLE, ///< an edge passes from one side of a triangle
                              ///< to the other through its inside; vertices:
                              ///< edge, triangle
    TF_POINT_ON_TRIANGLE,     ///< a vertex lies on a triangle; vertices: the
                              ///< vertex, triangle
    TF_EDGE_ON_EDGE,          ///< two edges have a point in common; vertices:
                              ///< of the one, of the other
} tf_crossing_kind;

/// Two elements that share no vertex, and intersect.
typedef struct tf_crossing {
    tf_crossing_kind kind; ///< how they intersect
    int vertex[5]; ///< each element's in increasing order, of two edges the one
                   ///< with the lowest vertex first; -1 where there is none
} tf_crossing;

/// All intersections of a surface.
typedef struct tf_crossings {
    size_t count;                ///< how many
    const tf_crossing *crossing; ///< sorted by kind, then by vertices
} tf_crossings;

/// How to check.  All zero: on the caller's thread.
typedef struct tf_check_options {
    size_t size; ///< sizeof(tf_check_options); 0: that of version 1.0
    const tf_parallel *parallel; ///< NULL: the caller's thread alone
    tf_progress *progress;       ///< NULL: nothing is told
    void *context;               ///< passed on to `progress`
} tf_check_options;

//: Declare how to check
/// Finds where a surface at rest intersects itself, exactly.
///
/// Pairs that share a vertex are not tested.  In space this misses only two
/// edges of no triangle that lie upon each other: if two triangles, or a
/// triangle and an edge, have more in common than the convex hull of their
/// common vertices, then two of their elements are listed.  Particles that lie
/// on edges of no triangle, or on each other, are not listed either.
///
/// A curve in the plane is checked for edges that intersect.  If the edge AB
/// lies on the edge AC, and BD is a third edge, then AC and BD are listed,
/// unless D is C; without such an edge the two are missed.  Particles are not
/// tested.
///
/// What a filter leaves out is not listed.  An edge and a triangle, or two edges
/// in the plane, are listed only if all pairs are kept whose contacts would show
/// that they begin to intersect in a step (tf_surface_set_filter).
///
/// @param surface the surface
/// @param vertices how many vertices have a position
/// @param position the coordinates of its vertices, three each, in the plane
///     two
/// @param options how; NULL: all zero
/// @param[out] found the intersections, lent until the next call for this
///     surface; set only with TF_OK
/// @param[out] error what is wrong, if anything; may be NULL
/// @return TF_OK; TF_BAD_COUNT if that is another number than the surface has;
///     TF_BAD_OPTION; TF_NOT_FINITE; TF_BAD_ENVIRONMENT; TF_OUT_OF_MEMORY; or
///     TF_CANCELLED
TF_API tf_status tf_surface_check(tf_surface *surface, int vertices,
                                  const double position[],
                                  const tf_check_options *options,
                                  tf_crossings *found, tf_error *error);

/// @}
