//: Declare circles of vertices
#pragma once

#include "geometry/vector.h"
#include "simulate/body.h"

/// Adds the vertices of a circle or, if the radii differ, an ellipse.
/// @param across, beside perpendicular radii; the first vertex is at the former
void tf_circle_add(tf_body *body, tf_vector center, tf_vector across,
                   tf_vector beside, int vertices);

//: Declare solids
/// Each adds a surface whose vertices are scripted.

/// A ball.
/// @param sectors how many triangles are around each pole, 3 or more
void tf_ball_add(tf_body *body, const double center[3], double radius,
                 int sectors);

/// A ring in a horizontal plane.
/// @param radius of the circle in the middle of the tube, and the tube's own
/// @param sectors how many segments the circle has, 3 or more
/// @param sides how many the tube has, 3 or more
void tf_ring_add(tf_body *body, const double center[3], const double radius[2],
                 int sectors, int sides);

/// An upright column that stands on a point.
/// @param sectors how many sides it has, 3 or more
/// @param rows how many rows of triangles, 1 or more
void tf_column_add(tf_body *body, const double foot[3], double radius,
                   double height, int sectors, int rows);

/// A floor: a horizontal square of two triangles.
void tf_floor_add(tf_body *body, double height, double side);
