//: Declare the loops over lanes
#pragma once

#include "fast/query_block.h"

#include <stddef.h>

/// A filter of all lanes of some blocks, in an IEEE environment.  A determinant
/// counts as certain if it is more than `share` Mx My Mz away from zero, where
/// M is the largest difference between coordinates of the two elements, at one
/// time and on one axis, plus 2^-300.  `masks`: one for every
/// TF_MASK_QUERIES, or part of them.  `clearance`: one number for each lane, as
/// tf_narrow_phase measures it; NULL: none are wanted.
typedef void tf_lanes_filter(size_t blocks, const tf_query_block block[],
                             double share, tf_query_masks masks[],
                             double clearance[]);

tf_lanes_filter tf_lanes_point_triangle, tf_lanes_edge_edge;

//: State which determinants are certain
// No number of a lane is this far from the true determinant, as
// tests/proofs/lanes.gappa proves; so beyond this its sign is certain.
#define TF_UNIT_ROUNDOFF 0x1p-53
#define TF_SHARE_SURE (256 * TF_UNIT_ROUNDOFF)

// Beyond this, tf_clamped is certain as well.  Its differences are at most 2 M,
// so the six products of its permanent are at most 8 Mx My Mz each, and its
// bound, 7 u times the permanent, is at most 336 u Mx My Mz.  It is certain of
// what is truly twice as far from zero; and what is beyond 1024 u as rounded is
// truly beyond 768 u.
#define TF_SHARE_CLAMPED (1024 * TF_UNIT_ROUNDOFF)
