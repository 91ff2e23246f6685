//: Declare the original of a surface
#pragma once

#include "base/status.h"
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

/// Finds the nearest point of the original; returns its distance.
double tf_original_nearest(tf_original *original, const double x[3],
                           double point[3]);

/// The greatest distance from the original at which a vertex of a surface is,
/// or the middle of a triangle; of no meaning if the caller cancels.
/// @param watch over the call; may be NULL
double tf_original_farthest(tf_original *original,
                            const tf_adaptive_surface *surface,
                            tf_watch *watch);
