//: Declare creases
#pragma once

#include "surgery/adaptive_surface.h"

/// Whether the edge of a corner is on the boundary, or its triangles' normals
/// are more than 60 degrees apart.
bool tf_is_crease(const tf_adaptive_surface *surface, int corner);

/// How a vertex may move without changing the shape.
typedef enum tf_freedom {
    TF_HELD = 0,     ///< a corner: not at all
    TF_ALONG_CREASE, ///< it is on a crease that goes on nearly straight
    TF_FREE,         ///< on no crease
} tf_freedom;

tf_freedom tf_freedom_of(const tf_adaptive_surface *surface, int vertex);
