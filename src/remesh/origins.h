//: Declare where vertices come from
#pragma once

#include "base/api.h"
#include "surgery/adaptive.h"

/// @addtogroup adaptive
/// @{

/// A point of a surface, on one of its triangles.
typedef struct tf_origin {
    int triangle;          ///< its number
    double barycentric[3]; ///< the weights of its corners, 0 or more; their sum
                           ///< is 1, up to rounding
} tf_origin;

/// Where the vertices of a surface that has been remeshed come from: for each of
/// them a point of the surface before tf_adaptive_remesh, with the numbers of
/// that time.  With these weights the values at the corners of a triangle become
/// the value at the vertex.
///
/// The point is where the vertex is, up to rounding; a vertex that has not moved
/// comes from a corner, with the weight 1, and one on a sharp edge or on the
/// boundary from a point of these.
///
/// Where sheets of the surface are near each other, the point is on the sheet
/// that has become the one of the vertex, even if another sheet is nearer.
///
/// @param surface the surface
/// @return one for each vertex, lent until the surface is changed; NULL if it
///     has been changed since it was remeshed, or never was
TF_API const tf_origin *tf_adaptive_origins(const tf_adaptive_surface *surface);

/// Where the corners of the triangles come from then: the same points as the
/// vertices, but on a triangle of the corner's own side of sharp edges, so that
/// what differs on the two sides, such as texture coordinates at a seam, is not
/// mixed with what is beyond.  No sharp edge is between the old triangles of the
/// three corners of a triangle: where sharp edges bound the faces of a label, it
/// has that of any of them.
///
/// Sharp edges become straighter, by the few vertices that are beyond them then;
/// these come from the nearest point on their own side.
///
/// @param surface the surface
/// @return three for each triangle, lent until the surface is changed; NULL if
///     it has been changed since it was remeshed, or never was
TF_API const tf_origin *
tf_adaptive_corner_origins(const tf_adaptive_surface *surface);

/// @}
