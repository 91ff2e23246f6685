//: Declare tetrahedra
#pragma once

#include "surgery/touch.h"

/// A closed tetrahedron, which may be flat: then it is the union of its four
/// faces, which is the same as the convex hull of its corners.
typedef struct tf_tetrahedron {
    int vertex[4];
    const double *corner[4];
    tf_sign orientation; ///< TF_ZERO: it is flat
} tf_tetrahedron;

tf_tetrahedron tf_tetrahedron_of(const int vertex[4],
                                 const double *const corner[4]);

/// Which corner a vertex is; -1: none.
int tf_tetrahedron_corner(const tf_tetrahedron *tetrahedron, int vertex);

//: Declare what is outside of a tetrahedron
/// Whether the plane of a face separates a triangle or an edge (`count` is 3 or
/// 2) from the tetrahedron, so that they have only common vertices in common.
bool tf_tetrahedron_is_apart(const tf_tetrahedron *tetrahedron, int count,
                             const tf_facet *element);

/// A bit for each face, 1 << i for the one opposite to corner i: whether a point
/// is strictly on the other side of it.  None if the tetrahedron is flat.
unsigned tf_tetrahedron_outside(const tf_tetrahedron *tetrahedron,
                                const double *p);

/// Whether a point, which is outside of these faces, is in the tetrahedron.
bool tf_tetrahedron_holds(const tf_tetrahedron *tetrahedron, const double *p,
                          unsigned outside);

//: Declare how an edge enters a tetrahedron
/// An edge: its ends, and the faces that these are outside of.
typedef struct tf_located_edge {
    int vertex[2];
    const double *end[2];
    unsigned outside[2];
} tf_located_edge;

/// Whether an edge, whose ends are outside unless they are corners, meets the
/// tetrahedron in more than their common vertices.  An edge whose ends are both
/// corners does not.
bool tf_tetrahedron_meets(const tf_tetrahedron *tetrahedron,
                          const tf_located_edge *edge);
