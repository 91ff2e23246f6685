//: Declare the zones of a tangled surface
#pragma once

#include "base/api.h"
#include "base/error.h"
#include "surface/check.h"
#include "surface/surface.h"

/// @addtogroup untangling
/// @{

/// Finds the zones of a surface that intersects itself, for a tf_detect_options
/// or tf_response_options that keeps everything else clear.
///
/// In zones are the triangles at both elements of each intersection that
/// tf_surface_check finds, and then, ring by ring, those that share a vertex
/// with one that is in already.  Triangles in zones are in the same one if they
/// share a vertex or belong to the same intersection, and if a chain of such
/// triangles connects them.  In the plane all this is true of edges.
///
/// An intersection of which an element has no triangle, as an edge of a rod,
/// adds nothing to a zone and is within none.  All others are within one, but
/// for those of a vertex at which such an edge ends.
///
/// The result is the same for any number of threads.
///
/// @param surface the surface
/// @param vertices how many vertices have a position
/// @param position the coordinates of its vertices, three each, in the plane
///     two
/// @param rings how many rings are added, 0 or more
/// @param options how to check; NULL: all zero
/// @param[out] zone of each triangle of tf_surface_triangles, in the plane of
///     each edge of tf_surface_edges: its zone, numbered from 0 in the order of
///     their first triangles; or -1: none.  Set only with TF_OK
/// @param[out] zones how many there are; set only with TF_OK; may be NULL
/// @param[out] found the intersections, lent until the next call for this
///     surface; set only with TF_OK; may be NULL
/// @param[out] error what is wrong, if anything; may be NULL
/// @return TF_OK; TF_BAD_COUNT if the surface has another number of vertices;
///     TF_BAD_OPTION, also for `rings`; TF_NOT_FINITE; TF_BAD_ENVIRONMENT;
///     TF_OUT_OF_MEMORY; or TF_CANCELLED
TF_API tf_status tf_surface_zones(tf_surface *surface, int vertices,
                                  const double position[], int rings,
                                  const tf_check_options *options, int zone[],
                                  int *zones, tf_crossings *found,
                                  tf_error *error);

/// @}
