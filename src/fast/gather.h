//: Declare the gathering of queries
#pragma once

#include "fast/query_block.h"
#include "query/narrow_phase.h"

#include <stdbool.h>

/// Gathers the coordinates of the queries begin to end - 1 into blocks, with
/// the vertices of each element in order.  There must be 1 to TF_MASK_QUERIES
/// of them; lanes of the last block that are left over repeat the last query.
/// False, and no blocks, if an index is bad.
bool tf_gather(const tf_queries *queries, size_t begin, size_t end,
               tf_query_block block[]);
