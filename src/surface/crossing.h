//: Declare how elements at rest intersect
#pragma once

#include <stdbool.h>

/// Whether the inside of the edge ab crosses the inside of the triangle cde:
/// exactly, for finite coordinates in space.
bool tf_edge_crosses_triangle(const double *a, const double *b, const double *c,
                              const double *d, const double *e);

/// Whether four points in space lie in a plane.
bool tf_are_coplanar(const double *a, const double *b, const double *c,
                     const double *d);

/// Whether the closed edges ab and cd in the plane have a point in common;
/// either may have no length.
bool tf_edges_cross(const double *a, const double *b, const double *c,
                    const double *d);
