//: Declare the loops over lanes
#pragma once

#include "fast/filter.h"

/// A filter of all lanes of some blocks, in an IEEE environment.  A determinant
/// counts as certain if it is more than `share` Mx My Mz away from zero, where
/// M is the largest difference of coordinates on an axis, or 2^-300 if that is
/// larger.  `masks`: one for every TF_MASK_QUERIES, or part of them.
typedef void tf_lanes_filter(size_t blocks, const tf_query_block block[],
                             double share, tf_query_masks masks[]);

tf_lanes_filter tf_lanes_point_triangle, tf_lanes_edge_edge;

//: State which determinants are certain
// The rounded determinant differs from the true one by less than SURE Mx My Mz:
// tests/proofs/filter.gappa.
#define TF_UNIT_ROUNDOFF 0x1p-53
#define TF_SHARE_SURE (48 * TF_UNIT_ROUNDOFF)

// Of a determinant beyond this, tf_clamped is certain as well.  Its own
// determinants have entries of at most 2 M, so permanents of at most 6 8 Mx My
// Mz, and a bound of 7 u times that, which the true determinant exceeds twice.
#define TF_SHARE_CLAMPED (1024 * TF_UNIT_ROUNDOFF)
