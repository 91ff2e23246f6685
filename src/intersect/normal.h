//: Declare the normal
#pragma once

#include "arithmetic/arithmetic.h"
#include "geometry/sweep.h"

/// The normal of a contact of two simplices: the cross product of the axes - 1
/// edges that they have within t = 0 and within t = 1 (in the plane: the edge,
/// turned left by 90 degrees), scaled to length 1.  Zero if those edges are
/// dependent or a rounded arithmetic overflows.
tf_vector tf_contact_normal(const tf_arithmetic *arithmetic, int axes,
                            const tf_simplex *s, const tf_simplex *r);
