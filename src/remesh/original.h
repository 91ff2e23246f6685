//: Declare the original of a surface
#pragma once

#include "base/status.h"
#include "geometry/vector.h"
#include "remesh/origins.h"
#include "surgery/adaptive_surface.h"

/// A surface to which the nearest points are found.
typedef struct tf_original {
    const tf_adaptive_surface *surface; ///< which stays as it is
    tf_buffer box, order;               ///< of its triangles
    tf_dynamic_tree tree;
} tf_original;

/// Begins to look for points of a surface.  Returns TF_OK, TF_OUT_OF_MEMORY or
/// TF_CANCELLED; free the original in any case.
/// @param watch over the call; may be NULL
tf_status tf_original_begin(tf_original *original,
                            const tf_adaptive_surface *surface,
                            tf_watch *watch);
void tf_original_free(tf_original *original);

/// A point of the original.
typedef struct tf_projection {
    tf_vector point;
    tf_origin origin; ///< which one it is
    double distance;  ///< from what was projected to it
} tf_projection;

/// Finds the nearest point of the original; if there is none, the distance is
/// infinite, and the point is the same.
tf_projection tf_original_project(tf_original *original, tf_vector point);
