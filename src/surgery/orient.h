//: Declare how triangles are oriented alike
#pragma once

#include "base/status.h"
#include "surgery/adaptive_surface.h"

/// Turns triangles over so that each edge of two triangles is passed in opposite
/// directions, as far as that is possible: across the seam of a surface with one
/// side it is not.  Of triangles that are connected over such edges, the fewer
/// are turned; if both are as many, those that the first one disagrees with.
/// The surface has no gaps.  Returns TF_OK or TF_OUT_OF_MEMORY.
/// @param[out] turned how many were turned
tf_status tf_orient_triangles(tf_adaptive_surface *surface, int *turned);
