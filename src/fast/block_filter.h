//: Declare the filter of points and triangles
#pragma once

#include "base/api.h"
#include "base/status.h"
#include "fast/query_block.h"

#include <stddef.h>

/// @addtogroup filters
/// @{

/// Decides by rounded numbers which of many points meet their triangles, where
/// that is certain, at about the speed at which memory delivers the blocks.
/// Thread-safe.
///
/// A certain verdict is that of tf_point_triangle with tf_exact or
/// tf_perturbed, proved by a bound on the rounding errors.  Undecided are
/// queries with a sign that may be zero, such as those of elements that touch;
/// those whose elements are too far apart or too large, so that the largest
/// differences between their coordinates, one on each axis, add up to more than
/// 2^300; and those with NaNs and infinities.  The masks are the same bits on
/// all machines.
///
/// @param count how many queries
/// @param block the queries, eight a block; the last block may have fewer, and
///     then the numbers of its other lanes are read but do not matter
/// @param[out] masks the verdicts, those of 64 queries each; set only with
///     TF_OK
/// @return TF_OK, or TF_BAD_ENVIRONMENT
TF_API tf_status tf_filter_point_triangle(size_t count,
                                          const tf_query_block block[],
                                          tf_query_masks masks[]);

//: Declare the filter of edges
/// The same for pairs of edges, whose verdicts are those of tf_edge_edge.
/// Thread-safe.
/// @param count how many queries
/// @param block the queries, eight a block, as above
/// @param[out] masks the verdicts, those of 64 queries each; set only with
///     TF_OK
/// @return TF_OK, or TF_BAD_ENVIRONMENT
TF_API tf_status tf_filter_edge_edge(size_t count, const tf_query_block block[],
                                     tf_query_masks masks[]);

/// @}
