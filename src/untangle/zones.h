//: Declare the zones of a tangle
#pragma once

#include "base/api.h"
#include "base/error.h"
#include "surface/surface.h"

/// @addtogroup untangling
/// @{

/// Finds the zones of a surface that intersects itself: connected sets of
/// elements, triangles in space and edges in the plane, that contain each pair
/// that intersects, so that all other pairs can be kept clear while those of a
/// zone are left out.
///
/// The `zone` of tf_detect_options and tf_response_options takes them: a pair is
/// left out if *all* triangles at both of its elements are in one zone.  Then
/// triangles that are not both in one zone, and are clear at the start of a step,
/// are clear at its end.  Within a zone nothing is promised.
///
/// @param surface the surface
/// @param vertices how many vertices have a position
/// @param position the coordinates of its vertices, three each, in the plane two
/// @param rings how many rings of neighbors around the elements that intersect
///     belong to their zones, 0 or more
/// @param[out] zone of each triangle, in the order of the mesh that the surface
///     was made from, or in the plane of each edge of tf_surface_edges: the
///     number of its zone, from 0, or -1 if it is in none; set only with TF_OK
/// @param[out] zones how many there are; set only with TF_OK; may be NULL
/// @param[out] error what is wrong, if anything; may be NULL
/// @return TF_OK; TF_BAD_COUNT if the surface has another number of vertices;
///     TF_BAD_OPTION; TF_NOT_FINITE; TF_BAD_ENVIRONMENT; or TF_OUT_OF_MEMORY
TF_API tf_status tf_surface_zones(tf_surface *surface, int vertices,
                                  const double position[], int rings,
                                  int zone[], int *zones, tf_error *error);

/// @}
