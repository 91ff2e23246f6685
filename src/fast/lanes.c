//: Include what lanes need
#include "fast/lanes.h"

#include "base/prefetch.h"
#include "base/simd.h"
#include "fast/clearance.h"
#include "fast/determinants.h"

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

//: Take a lane of a block
TF_ALWAYS_INLINE tf_vector vertex_of(const tf_query_block *block, int t, int v,
                                     int i)
{
    const double(*x)[TF_BLOCK_QUERIES] = block->at[t][v];
    return (tf_vector){{x[0][i], x[1][i], x[2][i]}};
}

TF_ALWAYS_INLINE tf_lane lane_of(const tf_query_block *block, int i)
{
    return (tf_lane){
        .start = {vertex_of(block, 0, 0, i), vertex_of(block, 0, 1, i),
                  vertex_of(block, 0, 2, i), vertex_of(block, 0, 3, i)},
        .end = {vertex_of(block, 1, 0, i), vertex_of(block, 1, 1, i),
                vertex_of(block, 1, 2, i), vertex_of(block, 1, 3, i)}};
}

//: Judge a query
/// Sets the bit of a query where its evidence is certain.  Nothing is, if a
/// product may overflow or a coordinate is not finite, which the maximum and
/// minimum of numbers can hide, but not their sum.
TF_ALWAYS_INLINE void judge(tf_lane_evidence shown, double share, uint64_t bit,
                            tf_query_masks *found)
{
    double error = share * shown.volume;
    double nothing = shown.sum - shown.sum;
    uint64_t known = shown.reach + nothing <= 0x1p300 ? bit : 0;
    uint64_t separated = shown.gap > 0 ? known : 0;
    uint64_t conflict = shown.conflict > error ? known : 0;
    uint64_t agreement = shown.agreement > error ? known : 0;
    found->separated |= separated;
    found->apart |= separated | conflict;
    found->hit |= agreement;
}

//: Judge a block of queries
static const uint64_t lane_bit[TF_BLOCK_QUERIES] = {
    1 << 0, 1 << 1, 1 << 2, 1 << 3, 1 << 4, 1 << 5, 1 << 6, 1 << 7,
};

/// Once inside a function that knows of what elements, and whether clearances are
/// wanted, this is one loop.
TF_ALWAYS_INLINE tf_query_masks judge_block(const tf_query_block *block,
                                            double share, bool of_edges,
                                            double clearance[TF_BLOCK_QUERIES])
{
    tf_query_masks found = {0};
    TF_LANE_LOOP
    for (int i = 0; i < TF_BLOCK_QUERIES; i++) {
        tf_lane lane = lane_of(block, i);
        tf_lane_tetrahedra tetrahedra;
        tf_lane_triangles triangles;
        tf_lane_evidence shown =
            of_edges ? tf_lane_edge_edge(&lane, &triangles)
                     : tf_lane_point_triangle(&lane, &tetrahedra);
        if (clearance)
            clearance[i] = tf_lane_clearance(&lane, &shown, of_edges);
        judge(shown, share, lane_bit[i], &found);
    }
    return found;
}

//: Prefetch a block
enum {
    NEAR = 6, ///< blocks ahead, 9 kilobytes, for the first cache
    FAR = 10  ///< 15 kilobytes, for the second
};

/// Asks for blocks that come later.  The first cache can wait for a few lines
/// only, so they come to it in two steps: from memory to the second cache, which
/// can wait for many, and from there in a moment.
TF_ALWAYS_INLINE void prefetch_ahead(size_t blocks,
                                     const tf_query_block block[], size_t i)
{
    if (blocks - i <= FAR)
        return;
    const double *near = &block[i + NEAR].at[0][0][0][0];
    const double *far = &block[i + FAR].at[0][0][0][0];
    for (int line = 0; line < 2 * 4 * 3; line++) {
        tf_prefetch(near + (ptrdiff_t)line * TF_BLOCK_QUERIES);
        tf_prefetch_far(far + (ptrdiff_t)line * TF_BLOCK_QUERIES);
    }
}

//: Add the bits of a block
/// Adds what is certain about a block to the masks of the 64 queries around it.
TF_ALWAYS_INLINE void add_bits(size_t i, tf_query_masks found,
                               tf_query_masks masks[])
{
    size_t blocks = TF_MASK_QUERIES / TF_BLOCK_QUERIES;
    size_t shift = i % blocks * TF_BLOCK_QUERIES;
    tf_query_masks *all = &masks[i / blocks];
    if (shift == 0)
        *all = (tf_query_masks){0};
    all->apart |= found.apart << shift;
    all->separated |= found.separated << shift;
    all->hit |= found.hit << shift;
    all->undecided = ~(all->apart | all->hit);
}

//: Filter blocks
TF_ALWAYS_INLINE void filter_blocks(size_t blocks, const tf_query_block block[],
                                    double share, tf_query_masks masks[],
                                    bool of_edges)
{
    for (size_t i = 0; i < blocks; i++) {
        prefetch_ahead(blocks, block, i);
        add_bits(i, judge_block(&block[i], share, of_edges, NULL), masks);
    }
}

/// Measures clearances as well.  This is for blocks that were just gathered and
/// are in the cache: none are prefetched.
TF_ALWAYS_INLINE void measure_blocks(size_t blocks,
                                     const tf_query_block block[], double share,
                                     tf_query_masks masks[], bool of_edges,
                                     double clearance[])
{
    for (size_t i = 0; i < blocks; i++) {
        double own[TF_BLOCK_QUERIES];
        add_bits(i, judge_block(&block[i], share, of_edges, own), masks);
        memcpy(clearance + i * TF_BLOCK_QUERIES, own, sizeof own);
    }
}

//: Compile the loops for several processors
TF_SIMD TF_NO_TRAPS static void filter_points(size_t blocks,
                                              const tf_query_block block[],
                                              double share,
                                              tf_query_masks masks[])
{
    filter_blocks(blocks, block, share, masks, false);
}

TF_SIMD TF_NO_TRAPS static void filter_edges(size_t blocks,
                                             const tf_query_block block[],
                                             double share,
                                             tf_query_masks masks[])
{
    filter_blocks(blocks, block, share, masks, true);
}

TF_SIMD TF_NO_TRAPS static void
measure_points(size_t blocks, const tf_query_block block[], double share,
               tf_query_masks masks[], double clearance[])
{
    measure_blocks(blocks, block, share, masks, false, clearance);
}

TF_SIMD TF_NO_TRAPS static void
measure_edges(size_t blocks, const tf_query_block block[], double share,
              tf_query_masks masks[], double clearance[])
{
    measure_blocks(blocks, block, share, masks, true, clearance);
}

//: Offer the loops
void tf_lanes_point_triangle(size_t blocks, const tf_query_block block[],
                             double share, tf_query_masks masks[],
                             double clearance[])
{
    if (clearance)
        measure_points(blocks, block, share, masks, clearance);
    else
        filter_points(blocks, block, share, masks);
}

void tf_lanes_edge_edge(size_t blocks, const tf_query_block block[],
                        double share, tf_query_masks masks[],
                        double clearance[])
{
    if (clearance)
        measure_edges(blocks, block, share, masks, clearance);
    else
        filter_edges(blocks, block, share, masks);
}
