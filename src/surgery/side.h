//: Declare sides and turns
#pragma once

#include "arithmetic/sign.h"

#include <stdbool.h>

/// The sign of the volume of the tetrahedron abcd, exact for any finite
/// coordinates: positive if, seen from d, the corners a, b and c turn
/// counterclockwise.
tf_sign tf_side(const double *a, const double *b, const double *c,
                const double *d);

/// The same in the plane of two axes: the sign of the area of the triangle abc.
tf_sign tf_turn(const int axis[2], const double *a, const double *b,
                const double *c);

/// Whether the exact area of the triangle abc in space is zero.
bool tf_are_collinear(const double *a, const double *b, const double *c);

//: Name the coordinate planes
/// Two points that differ in space differ in at least two of these planes, and
/// elements of one plane of space meet if they meet, projected, in all three.
extern const int tf_planes[3][2];
