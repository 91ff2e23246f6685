//: Declare the velocities of a contact
#pragma once

#include "geometry/sweep.h"

/// The displacement of the pivot of S minus that of the pivot of R, on the
/// first `axes` axes; a component that overflows becomes +-DBL_MAX.
tf_vector tf_relative_velocity(int axes, const tf_simplex *s,
                               const tf_simplex *r);

/// velocity . normal, with a normal of length 1 or 0; +-DBL_MAX where it
/// overflows.
double tf_normal_velocity(tf_vector velocity, tf_vector normal);
