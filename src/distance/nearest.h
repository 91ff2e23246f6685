//: Declare how nearest points are found
#pragma once

#include "distance/nearest_points.h"
#include "query/kind.h"

/// What tf_distance finds, for elements whose vertices are at x[], the first
/// element's first.  In an IEEE environment.
tf_nearest tf_nearest_of(tf_kind kind, const double *const x[]);
