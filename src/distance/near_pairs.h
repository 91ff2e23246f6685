//: Declare how near pairs are found
#pragma once

#include "base/api.h"
#include "distance/near_pair.h"
#include "surface/check.h"

/// @addtogroup distances
/// @{

/// Finds the pairs of elements of a surface at rest that are nearer to each
/// other than a length, exactly: a vertex and a triangle, or two edges; in
/// the plane a vertex and an edge.  Pairs that share a vertex are not
/// tested, nor those that a filter leaves out.  If there are none, and
/// tf_surface_check finds none either, no points of two triangles or edges
/// that share no vertex are nearer than that.
///
/// @param surface the surface
/// @param vertices how many vertices have a position
/// @param position the coordinates of its vertices, three each, in the plane
///     two
/// @param length more than 0, finite
/// @param options how; NULL: all zero
/// @param[out] found the pairs, lent until the next call for this surface; set
///     only with TF_OK
/// @param[out] error what is wrong, if anything; may be NULL
/// @return TF_OK; TF_BAD_COUNT if that is another number than the surface has;
///     TF_BAD_OPTION; TF_NOT_FINITE; TF_BAD_ENVIRONMENT; TF_OUT_OF_MEMORY; or
///     TF_CANCELLED
TF_API tf_status tf_surface_near(tf_surface *surface, int vertices,
                                 const double position[], double length,
                                 const tf_check_options *options,
                                 tf_near_pairs *found, tf_error *error);

/// @}
