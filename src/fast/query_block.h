//: Count the queries of a block
#pragma once

#include "base/api.h"

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

/// @}
