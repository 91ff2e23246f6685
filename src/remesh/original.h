//: Declare the original of a surface
#pragma once

#include "surgery/adaptive_surface.h"

/// A copy of a surface, to which the nearest points are found.
typedef struct tf_original {
    int vertices, triangles;
    tf_buffer position, vertex, box, order;
    tf_dynamic_tree tree;
} tf_original;

/// Copies a surface without gaps.  False if there is no memory; free it in any
/// case.
bool tf_original_copy(tf_original *original,
                      const tf_adaptive_surface *surface);
void tf_original_free(tf_original *original);

/// Finds the nearest point of the original; returns its distance.
double tf_original_nearest(tf_original *original, const double x[3],
                           double point[3]);

/// The greatest distance from the original at which a vertex of another one is,
/// or the middle of a triangle.
double tf_original_farthest(tf_original *original, const tf_original *other);
