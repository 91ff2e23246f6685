//: Count the queries of a block
#pragma once

#include "base/api.h"
#include "base/status.h"

#include <stddef.h>
#include <stdint.h>

/// @addtogroup filters Filters
/// @{

/// How many queries there are to what holds several.
enum tf_filter_size {
    TF_BLOCK_QUERIES = 8, ///< queries a block: a row of it is a cache line
    TF_MASK_QUERIES = 64, ///< queries a mask: a bit each
};

//: Declare blocks of queries
/// Up to eight queries in space, side by side, so that a vector unit takes
/// them all at once.
///
/// `at[t][v][k][i]` is coordinate k (x, y, z) of vertex v of query i, at the
/// start (t = 0) or the end (t = 1) of the step, in any one unit of length.
/// The vertices are those of the first element, then those of the second: a
/// point and the three of a triangle, or two of each edge.  Those of an element
/// come in the order of their indices, the lowest first, because that is the
/// order in which it is swept.  Blocks that begin at a multiple of 64 bytes are
/// read fastest.
typedef struct tf_query_block {
    double at[2][4][3][TF_BLOCK_QUERIES]; ///< coordinates
} tf_query_block;

//: Declare verdicts as bits
/// What is certain about 64 queries, eight blocks of them.  Bit i, which counts
/// 2^i, is about query i; of `apart`, `hit` and `undecided` exactly one has it
/// set.  Bits without a query are zero.
typedef struct tf_query_masks {
    uint64_t apart;     ///< the elements do not meet
    uint64_t separated; ///< that needs no sign: along an axis one is strictly
                        ///< to the same side of the other at both ends; these
                        ///< queries are in `apart` as well
    uint64_t hit;       ///< the elements meet
    uint64_t undecided; ///< not certain: leave them to tf_reference
} tf_query_masks;

//: Declare the filter of points and triangles
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
