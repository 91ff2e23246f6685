//: Declare butterfly points
#pragma once

#include "remesh/measure.h"

/// Where the edge of a corner should be split so that the surface curves on:
/// the point that the two triangles on the edge and the four around them
/// suggest.  Where one of these is missing, the middle of the edge.
tf_vector tf_butterfly_point(const tf_adaptive_surface *surface, int corner);
