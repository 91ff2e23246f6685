//: Include what the vector narrow phase needs
#include "fast/vector.h"

#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/perturbed.h"
#include "base/environment.h"
#include "base/request.h"
#include "base/require.h"
#include "fast/lanes.h"

#include <stdalign.h>
#include <stdbool.h>
#include <string.h>

//: Choose when a determinant is certain
/// How far from zero a determinant must be for an arithmetic to agree with the
/// filter, as a share of Mx My Mz; 0: the filter cannot stand in for it.
///
/// A sign that is certain and not zero is that of the perturbed scene, too.
/// tf_clamped is certain of the same signs where they are far enough from zero,
/// and signs that are certain decide alike for it and for tf_report.
static double share_for(const tf_arithmetic *arithmetic)
{
    if (arithmetic == &tf_exact || arithmetic == &tf_perturbed)
        return TF_SHARE_SURE;
    if (arithmetic == &tf_clamped || arithmetic == &tf_report)
        return TF_SHARE_CLAMPED;
    return 0;
}

/// The filter of a kind of queries; NULL: there is none.
static tf_lanes_filter *filter_for(tf_kind kind)
{
    return kind == TF_POINT_TRIANGLE ? tf_lanes_point_triangle
           : kind == TF_EDGE_EDGE    ? tf_lanes_edge_edge
                                     : NULL;
}

//: Sort the vertices of a query
static void sort_two(int *a, int *b)
{
    int low = *a < *b ? *a : *b, high = *a < *b ? *b : *a;
    *a = low;
    *b = high;
}

/// Puts those of each element in order.
static void sort_vertices(tf_kind kind, int vertex[4])
{
    if (kind == TF_EDGE_EDGE) {
        sort_two(&vertex[0], &vertex[1]);
        sort_two(&vertex[2], &vertex[3]);
    } else {
        sort_two(&vertex[1], &vertex[2]);
        sort_two(&vertex[2], &vertex[3]);
        sort_two(&vertex[1], &vertex[2]);
    }
}

//: Check the vertices of a query
static bool are_good(int vertices, const int vertex[4])
{
    // As unsigned numbers, negative ones are too large.
    unsigned end = vertices < 0 ? 0 : (unsigned)vertices;
    bool bad = false;
    for (int i = 0; i < 4; i++) {
        bad |= (unsigned)vertex[i] >= end;
        for (int j = 0; j < i; j++)
            bad |= vertex[i] == vertex[j];
    }
    return !bad;
}

//: Gather the coordinates of a query
static void gather_vertex(const double x[3], double row[3][TF_BLOCK_QUERIES],
                          size_t lane)
{
    for (int k = 0; k < 3; k++)
        row[k][lane] = x[k];
}

/// Puts a query into its lane; false if an index is bad.
static bool gather_query(tf_kind kind, const tf_motion *motion,
                         const int given[4], tf_query_block *block, size_t lane)
{
    int vertex[4];
    memcpy(vertex, given, sizeof vertex);
    if (!are_good(motion->vertices, vertex))
        return false;
    sort_vertices(kind, vertex);
    for (int v = 0; v < 4; v++) {
        ptrdiff_t place = (ptrdiff_t)3 * vertex[v];
        gather_vertex(motion->start + place, block->at[0][v], lane);
        gather_vertex(motion->end + place, block->at[1][v], lane);
    }
    return true;
}

//: Request the vertices of a query early
enum {
    QUERIES_AHEAD = 48
};

TF_INSIDE void request_vertices(const tf_motion *motion, const int vertex[4])
{
    for (int v = 0; v < 4; v++) {
        if (vertex[v] < 0 || vertex[v] >= motion->vertices)
            return;
        ptrdiff_t place = (ptrdiff_t)3 * vertex[v];
        tf_request(motion->start + place);
        tf_request(motion->end + place);
    }
}

//: Gather as many queries as a mask has bits
enum {
    MASK_BLOCKS = TF_MASK_QUERIES / TF_BLOCK_QUERIES
};

/// Gathers the queries begin to end - 1; false if an index is bad.
static bool gather_queries(const tf_queries *queries, size_t begin, size_t end,
                           tf_query_block block[MASK_BLOCKS])
{
    const int *vertex = queries->vertices;
    if ((end - begin) % TF_BLOCK_QUERIES != 0)
        memset(&block[(end - begin) / TF_BLOCK_QUERIES], 0, sizeof *block);
    for (size_t i = begin; i < end; i++) {
        if (queries->count - i > QUERIES_AHEAD)
            request_vertices(queries->motion, vertex + 4 * (i + QUERIES_AHEAD));
        if (!gather_query(queries->kind, queries->motion, vertex + 4 * i,
                          &block[(i - begin) / TF_BLOCK_QUERIES],
                          (i - begin) % TF_BLOCK_QUERIES))
            return false;
    }
    return true;
}

//: Leave queries to the reference
static tf_status leave_to_reference(const tf_arithmetic *arithmetic,
                                    const tf_queries *queries, size_t begin,
                                    size_t end, tf_verdict verdict[],
                                    size_t *separated)
{
    tf_queries some = *queries;
    some.count = end - begin;
    some.vertices += 4 * begin;
    return tf_reference.decide(arithmetic, &some, verdict + begin, separated);
}

//: Turn bits into verdicts
/// Stops at the first bad query, as the reference does: a coordinate that is
/// not finite leaves its query undecided.
static tf_status spread(const tf_arithmetic *arithmetic,
                        const tf_queries *queries, size_t begin, size_t end,
                        const tf_query_masks *masks, tf_verdict verdict[],
                        size_t *separated)
{
    for (size_t i = begin; i < end; i++) {
        size_t lane = i - begin;
        if (masks->undecided >> lane & 1) {
            tf_status status = leave_to_reference(arithmetic, queries, i, i + 1,
                                                  verdict, separated);
            if (status != TF_OK)
                return status;
            continue;
        }
        verdict[i] = masks->hit >> lane & 1 ? TF_HIT : TF_APART;
        *separated += masks->separated >> lane & 1;
    }
    return TF_OK;
}

//: Decide as many queries as a mask has bits
static tf_status decide_some(const tf_arithmetic *arithmetic,
                             const tf_queries *queries, size_t begin,
                             size_t end, tf_verdict verdict[],
                             size_t *separated)
{
    alignas(64) tf_query_block block[MASK_BLOCKS];
    if (!gather_queries(queries, begin, end, block))
        return leave_to_reference(arithmetic, queries, begin, end, verdict,
                                  separated);
    tf_query_masks masks;
    size_t blocks = (end - begin + TF_BLOCK_QUERIES - 1) / TF_BLOCK_QUERIES;
    filter_for(queries->kind)(blocks, block, share_for(arithmetic), &masks);
    return spread(arithmetic, queries, begin, end, &masks, verdict, separated);
}

//: Decide many queries by vectors
static tf_status decide_by_vectors(const tf_arithmetic *arithmetic,
                                   const tf_queries *queries,
                                   tf_verdict verdict[], size_t *separated)
{
    TF_REQUIRE(arithmetic && queries && separated);
    if (share_for(arithmetic) == 0 || !filter_for(queries->kind) ||
        !tf_environment_is_ieee())
        return tf_reference.decide(arithmetic, queries, verdict, separated);
    TF_REQUIRE((queries->vertices && verdict) || queries->count == 0);
    const tf_motion *motion = queries->motion;
    TF_REQUIRE((motion && motion->start && motion->end) || queries->count == 0);
    size_t count = queries->count;
    for (size_t begin = 0; begin < count; begin += TF_MASK_QUERIES) {
        size_t end =
            count - begin < TF_MASK_QUERIES ? count : begin + TF_MASK_QUERIES;
        tf_status status =
            decide_some(arithmetic, queries, begin, end, verdict, separated);
        if (status != TF_OK)
            return status;
    }
    return TF_OK;
}

const tf_narrow_phase tf_vectorized = {.name = "vector",
                                       .decide = decide_by_vectors};
