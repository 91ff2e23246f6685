//: Include what the filters need
#include "fast/block_filter.h"

#include "base/environment.h"
#include "base/require.h"
#include "fast/lanes.h"

//: Clear the bits of no query
/// Clears the bits of the last masks that are of no query.
static void clear_rest(size_t count, tf_query_masks masks[])
{
    size_t used = count % TF_MASK_QUERIES;
    if (used == 0)
        return;
    tf_query_masks *last = &masks[count / TF_MASK_QUERIES];
    uint64_t queries = (UINT64_C(1) << used) - 1;
    last->apart &= queries;
    last->separated &= queries;
    last->hit &= queries;
    last->undecided &= queries;
}

//: Filter all queries
static tf_status filter_all(tf_lanes_filter *filter, size_t count,
                            const tf_query_block block[],
                            tf_query_masks masks[])
{
    TF_REQUIRE((block && masks) || count == 0);
    if (!tf_environment_is_ieee())
        return TF_BAD_ENVIRONMENT;
    size_t blocks = count / TF_BLOCK_QUERIES + (count % TF_BLOCK_QUERIES != 0);
    filter(blocks, block, TF_SHARE_SURE, masks, NULL);
    clear_rest(count, masks);
    return TF_OK;
}

//: Offer the filters
tf_status tf_filter_point_triangle(size_t count, const tf_query_block block[],
                                   tf_query_masks masks[])
{
    return filter_all(tf_lanes_point_triangle, count, block, masks);
}

tf_status tf_filter_edge_edge(size_t count, const tf_query_block block[],
                              tf_query_masks masks[])
{
    return filter_all(tf_lanes_edge_edge, count, block, masks);
}
