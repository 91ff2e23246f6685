//: Declare ropes
#pragma once

#include "simulate/cloth.h"

/// A line that a rope follows, by points that are at equal distances.
typedef struct tf_line {
    int points;
    double *x; ///< three coordinates each; NULL: there was no memory
} tf_line;

/// An overhand knot: a trefoil knot about the vertical axis, cut open, whose
/// ends point along the second axis, away from each other.
/// @param scale the inner and the outer radius are 1 and 3 times that, in meters
/// @param tail how long each end is, in units of the scale
/// @param spacing how far the points are from each other, in meters
tf_line tf_knot_line(double scale, double tail, double spacing);
void tf_line_free(tf_line *line);

//: Declare how to add a rope
/// Adds a rope along a line: an elastic tube, a circle of vertices at each point,
/// with struts across it.
/// @param radius less than the radius of the line's curvature
/// @param sides of the tube, an even number
/// @param material without a resistance to folds: the struts keep it in shape
void tf_rope_add(tf_body *body, const tf_line *line, double radius, int sides,
                 const tf_material *material);
