//: Declare how simplices at rest touch
#pragma once

#include "surgery/side.h"

// All simplices are closed: touching counts.  All answers are exact, for any
// finite coordinates.  Triangles may be collinear, edges points, unless it says
// otherwise.

/// Whether a point lies on a triangle.
bool tf_point_touches_triangle(const double *p, const double *const corner[3]);

/// Whether an edge has a point in common with a triangle.
bool tf_edge_touches_triangle(const double *p, const double *q,
                              const double *const corner[3]);

//: Declare how triangles overlap
/// The corners of a triangle, and their vertices' numbers.
typedef struct tf_facet {
    int vertex[3];
    const double *corner[3];
} tf_facet;

/// Whether two triangles have more in common than the convex hull of the
/// vertices that they share.  One of them may be collinear; then it also counts
/// that a single vertex that they share is between its two others.
bool tf_facets_overlap(const tf_facet *a, const tf_facet *b);
