// Small adaptive surfaces, given by numbers.
#ifndef SUPPORT_ADAPTIVE_SURFACES_H
#define SUPPORT_ADAPTIVE_SURFACES_H

#include "surgery/adaptive.h"

#include <stdint.h>

/// The surface of good triangles.
tf_adaptive_surface *adaptive_of(int vertices, double position[][3],
                                 int triangles, const int triangle[]);

/// A regular tetrahedron around the origin: (1, 1, 1), (1, -1, -1), (-1, 1, -1)
/// and (-1, -1, 1).
tf_adaptive_surface *adaptive_tetrahedron(void);

/// A flat sheet of squares on the lattice, with the vertex i + j * (columns + 1)
/// at (i, j, 0), each square divided from (i, j) to (i + 1, j + 1).
tf_adaptive_surface *adaptive_sheet(int columns, int rows);

/// The position of a vertex.
const double *coordinates_of(const tf_adaptive_surface *surface, int vertex);

/// How many triangles there are, without gaps.
int triangles_of(const tf_adaptive_surface *surface);

/// A number that depends on all that a surface is, its numbers and gaps included.
uint64_t adaptive_hash(const tf_adaptive_surface *surface);

/// Whether there is a triangle with these vertices, in this orientation.
int has_triangle(const tf_adaptive_surface *surface, int a, int b, int c);

/// Leaves a vertex alone, as if it had a defect.
void adaptive_freeze(tf_adaptive_surface *surface, int vertex);

/// A prism of height 1 over a regular polygon of radius 1; at most 64 sides.
tf_adaptive_surface *adaptive_prism(int sides);

#endif
