//: Declare nearest points
#pragma once

#include "geometry/vector.h"

#include <stdbool.h>

enum {
    TF_MOST_CORNERS = 6 ///< of two elements: two triangles
};

/// A point of each of two elements: barycentric coordinates by vertex, those of
/// the first element first; the coordinates of each element sum to 1.
typedef struct tf_point_pair {
    double distance; ///< between the two points
    double weight[TF_MOST_CORNERS];
} tf_point_pair;

/// The nearest points of two elements, whose vertices are x[0..vertices-1] and
/// x[vertices..vertices+others-1]: 1 + 2, 1 + 3, 2 + 2 or 3 + 3.  In the plane
/// the third coordinates are zero.  Correct up to rounding, however degenerate
/// the elements are.  Where products overflow the distance is infinite.
tf_point_pair tf_nearest_points(int vertices, int others, const tf_vector x[]);

/// The square of the distance of a point x[0] from a triangle x[1..3], up to
/// rounding: faster than to look for the nearest point.
double tf_squared_distance(const tf_vector x[4]);

//: Declare the coordinates where elements cross
/// The barycentric coordinates at which the lines or planes of two elements (1
/// + 2, 1 + 3 or 2 + 2 vertices) are nearest, negative ones included: those of
/// the common point, if they have one.  False where they are not defined: for
/// elements without length or area and for parallel edges.
bool tf_crossing_weights(int vertices, int others, const tf_vector x[],
                         double weight[]);

/// Whether all of `count` coordinates are at least `least`.
bool tf_weights_reach(int count, const double weight[], double least);
