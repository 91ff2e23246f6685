//: Declare how far triangles reach
#pragma once

#include "remesh/measure.h"
#include "remesh/original.h"

/// The greatest distance of points from a surface is between these two, up to
/// rounding.
typedef struct tf_reach {
    double least, most;
} tf_reach;

/// Encloses the greatest distance of the points of a triangle from a surface.
/// The bounds are usually no farther from each other than `fine`, or a part of
/// 1/100; but where the triangle is far from the surface, or above very many
/// others, the upper one may be too high.  Of no meaning if the caller cancels.
/// @param watch over the call; may be NULL
tf_reach tf_triangle_reach(tf_original *original, const tf_shape *triangle,
                           double fine, tf_watch *watch);

/// What is wanted of each triangle of a surface.
typedef struct tf_reach_each {
    double *most;  ///< how far it reaches at most
    double enough; ///< distances up to this needn't be told apart
} tf_reach_each;

/// Encloses that of all triangles of a surface.
/// @param[out] each may be NULL, and then only the greatest distance is looked
///     for, which is much faster
tf_reach tf_surface_reach(tf_original *original,
                          const tf_adaptive_surface *surface, double fine,
                          tf_reach_each *each, tf_watch *watch);
