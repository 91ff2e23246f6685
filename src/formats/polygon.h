//: Declare how to triangulate a polygon
#pragma once

#include <stdbool.h>

/// A corner that is left of a polygon.
typedef struct tf_corner {
    double x[3];      ///< from the first corner, scaled
    int vertex;       ///< its index
    int before, next; ///< the corners beside it
    bool is_convex;   ///< it turns as the polygon does
    bool is_ear;      ///< its triangle can be cut off
} tf_corner;

/// The polygon that is being divided.  All zero: there is none yet.
typedef struct tf_polygon {
    tf_corner *corner;
    int count, room;
    int axis[2]; ///< of the plane, in which it turns counterclockwise
} tf_polygon;

//: Declare how to divide a polygon
/// Divides a polygon, convex or not, into count - 2 triangles that turn as it
/// does.  They depend on the positions and indices of the corners and on
/// nothing else, not even on the corner at which the list begins:
/// The polygon is projected along the axis to which its normal (the sum of the
/// cross products of its sides) is nearest; x comes before y, and y before z.
/// Its corners are counted from the one of the least index.  If all triangles
/// of the fan around that corner turn as the polygon does, these it is, so of a
/// convex polygon always.  If not, ears are cut off, each time the first one in
/// this order: a corner whose triangle with its two neighbors turns as the
/// polygon does, and holds no other corner.  Where there is no ear (the polygon
/// crosses itself, or is a line), the rest is the fan around the first corner.
/// The signs are those of rounded differences.
/// Where the fan is not good, that takes a time as the square of the count.
/// @param position three coordinates of each vertex
/// @param count of corners, 3 or more
/// @param vertex of each corner, all different
/// @param triangle three vertices each
/// @return false: there is no memory
bool tf_polygon_divide(tf_polygon *polygon, const double position[], int count,
                       const int vertex[], int triangle[]);

void tf_polygon_free(tf_polygon *polygon);
