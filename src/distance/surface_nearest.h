//: Declare the nearest point of a surface
#pragma once

#include "base/api.h"
#include "base/error.h"
#include "surface/surface.h"

/// @addtogroup distances
/// @{

/// A point of a surface, and how far it is from somewhere.
typedef struct tf_surface_point {
    int corners;   ///< of the element that has it: 3 of a triangle, 2 of
                   ///< an edge, 1 of a vertex
    int vertex[3]; ///< these, in increasing order; -1 where there is none
    double barycentric[3]; ///< the point's, at least 0, with the sum 1 up to
                           ///< rounding; unused ones are zero
    double lower; ///< the distance is at least this, as that of tf_distance
    double upper; ///< and at most this
} tf_surface_point;

/// Finds the point of a surface at rest that is nearest to a point: of several,
/// or of those whose distances differ by no more than what rounding does, that of
/// the first triangle, the first edge, or the first vertex.  Looks at all
/// elements, once.  Filters play no part.  Thread-safe.
///
/// @param surface the surface
/// @param vertices how many vertices have a position
/// @param position the coordinates of its vertices, three each, in the plane
///     two
/// @param point as many coordinates
/// @param[out] nearest the answer; set only with TF_OK
/// @param[out] error what is wrong, if anything; may be NULL
/// @return TF_OK; TF_BAD_COUNT if that is another number than the surface has;
///     TF_NOT_FINITE; or TF_BAD_ENVIRONMENT
TF_API tf_status tf_surface_nearest(const tf_surface *surface, int vertices,
                                    const double position[],
                                    const double point[],
                                    tf_surface_point *nearest, tf_error *error);

/// @}
