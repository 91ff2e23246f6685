//: Declare sharp edges
#pragma once

#include "geometry/vector.h"
#include "surgery/adaptive_surface.h"

/// Whether the edge of a corner is on the boundary, or its triangles' normals
/// are more than 60 degrees apart.
bool tf_is_sharp_edge(const tf_adaptive_surface *surface, int corner);

/// How a vertex may move without changing the shape.
typedef enum tf_freedom {
    TF_HELD = 0,         ///< a corner: not at all
    TF_ALONG_SHARP_EDGE, ///< along a sharp edge that goes on nearly straight
    TF_FREE,             ///< it is on no sharp edge
} tf_freedom;

tf_freedom tf_freedom_of(const tf_adaptive_surface *surface, int vertex);

//: Declare collapses
/// How an edge collapses: which vertex goes, which stays, and where.
typedef struct tf_edge_collapse {
    int from, to;
    tf_vector position;
} tf_edge_collapse;

/// The freer of two vertices, at a corner and at the next one, goes to the
/// other.  False if it may not: if it is held, or if it may only go along a
/// sharp edge and this one is none.
bool tf_collapse_freer(const tf_adaptive_surface *surface, int corner,
                       const tf_freedom freedom[2], bool sharp,
                       tf_edge_collapse *collapse);
