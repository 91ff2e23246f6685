//: Declare the winding number
#pragma once

#include "surgery/side.h"

/// What a triangle adds to how often triangles go around a point.  Where they
/// have no boundary, and the point is on none of them, the sum is exact: 0
/// outside, 1 inside, -1 inside of what is turned inwards.
int tf_winding_part(const double *const corner[3], const double point[3]);
