//: Declare the lanes of a block
#pragma once

#include "fast/filter.h"

/// A filter of all 64 lanes of a block.  A determinant counts as certain if it
/// is more than `share` Mx My Mz away from zero, where M is the largest
/// difference of coordinates on an axis, or 2^-300 if that is larger.
typedef tf_query_masks tf_lanes_filter(const tf_query_block *block,
                                       double share);

tf_lanes_filter tf_lanes_point_triangle, tf_lanes_edge_edge;
