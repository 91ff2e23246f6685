//: Include what the vector narrow phase needs
#include "fast/vectorized.h"

#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/perturbed.h"
#include "arithmetic/published.h"
#include "base/environment.h"
#include "base/require.h"
#include "fast/gather.h"
#include "fast/lanes.h"
#include "query/apart.h"
#include "query/query.h"
#include "query/shape.h"
#include "surface/crossing.h"

#include <math.h>
#include <stdalign.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

//: Choose when a determinant is certain
/// How far from zero a determinant must be for an arithmetic to agree with the
/// filter, as a share of Mx My Mz; 0: the filter cannot stand in for it.
///
/// A sign that is certain and not zero is that of the perturbed scene, too.
/// tf_clamped is certain of the same signs where they are far enough from zero,
/// and signs that are certain decide alike for it and for tf_published.
static double share_for(const tf_arithmetic *arithmetic)
{
    if (arithmetic == &tf_exact || arithmetic == &tf_perturbed)
        return TF_SHARE_SURE;
    if (arithmetic == &tf_clamped || arithmetic == &tf_certain ||
        arithmetic == &tf_published)
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

//: Leave queries to the reference
/// Leaves clearances as they are.
static tf_status leave_to_reference(const tf_arithmetic *arithmetic,
                                    const tf_queries *queries, size_t begin,
                                    size_t end, tf_verdict verdict[],
                                    size_t *separated)
{
    tf_queries some = *queries;
    some.count = end - begin;
    some.vertices += 4 * begin;
    return tf_reference.decide(NULL, arithmetic, &some, verdict + begin,
                               separated);
}

//: Look for directions that separate queries
/// Whether a query that certainly is apart is so for an arithmetic.  This is no
/// verdict of tf_clamped and tf_published, for which signs that are unknown may
/// make a hit of it.
static bool is_certain(const tf_arithmetic *arithmetic)
{
    return arithmetic != &tf_clamped && arithmetic != &tf_published;
}

enum {
    MANY = 4 ///< undecided queries of a block, which are worth a second look
};

/// Decides undecided queries whose elements may move and certainly stay apart.
/// Measures blocks with many of these, if clearances were not wanted.
static void decide_by_clearance(size_t blocks, const tf_query_block block[],
                                tf_lanes_filter *filter, bool measured,
                                tf_query_masks *masks, double clearance[])
{
    for (size_t i = 0; i < blocks; i++) {
        size_t first = i * TF_BLOCK_QUERIES;
        double *own = clearance + first;
        tf_query_masks of_block;
        uint64_t undecided = masks->undecided >> first & 0xff;
        if (__builtin_popcountll(undecided) < MANY)
            continue;
        if (!measured)
            filter(1, &block[i], TF_SHARE_SURE, &of_block, own);
        for (int lane = 0; lane < TF_BLOCK_QUERIES; lane++)
            if (own[lane] > 0)
                masks->undecided &= ~(UINT64_C(1) << (first + (size_t)lane));
    }
}

//: Compare four places with a plane
typedef enum flatness {
    FLAT,     ///< or so nearly that rounded numbers see no difference
    NOT_FLAT, ///< certainly
    UNKNOWN   ///< where products may over- or underflow
} flatness;

static tf_vector from_first(const double *const x[4], int i)
{
    return tf_vector_difference(tf_vector_at(x[i], 0), tf_vector_at(x[0], 0));
}

static double sum_of_sizes(tf_vector v)
{
    return fabs(v.x[0]) + fabs(v.x[1]) + fabs(v.x[2]);
}

/// Whether four places lie in one plane.
static flatness flatness_of(const double *const x[4])
{
    tf_vector a = from_first(x, 1), b = from_first(x, 2), c = from_first(x, 3);
    double volume = tf_vector_dot(a, tf_vector_cross(b, c));
    double one = sum_of_sizes(a), two = sum_of_sizes(b),
           three = sum_of_sizes(c);
    double size = one * two * three;
    const double most = 0x1p297;
    if (!(one < most && two < most && three < most && size > 0x1p-700))
        return UNKNOWN;
    // Rounding loses less than 12 u size, with u = 2^-53.
    return fabs(volume) > 0x1p-49 * size ? NOT_FLAT : FLAT;
}

//: Look at queries at rest and flat ones
static bool is_at_rest(const double *const start[4], const double *const end[4])
{
    for (int v = 0; v < 4; v++)
        for (int k = 0; k < TF_AXES; k++)
            if (start[v][k] != end[v][k])
                return false;
    return true;
}

/// Whether a query that no axis separates is certainly apart.  Looks where exact
/// signs take long: at elements at rest, and at those that lie in one plane at
/// the start and in one at the end.
static bool is_apart(const tf_queries *queries, size_t query)
{
    const tf_query_shape *shape = tf_query_shape_of(queries->kind);
    const int *vertex = queries->vertices + 4 * query;
    const double *start[4], *end[4];
    for (int v = 0; v < 4; v++) {
        start[v] = queries->motion->start + (ptrdiff_t)3 * vertex[v];
        end[v] = queries->motion->end + (ptrdiff_t)3 * vertex[v];
    }
    bool rests = is_at_rest(start, end);
    flatness at_start = flatness_of(start);
    if (at_start != FLAT)
        return at_start == NOT_FLAT && rests;
    if (!rests && flatness_of(end) != FLAT)
        return false;
    tf_difference_list list = {.count = 0};
    tf_list_differences(shape->vertices, shape->others, start, &list);
    if (!rests)
        tf_list_differences(shape->vertices, shape->others, end, &list);
    return tf_certainly_apart(&list) ||
           (rests && !tf_are_coplanar(start[0], start[1], start[2], start[3]));
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
        if (masks->undecided >> lane & 1 &&
            !(is_certain(arithmetic) && is_apart(queries, i))) {
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
/// Sets clearances as well, unless they are NULL; they were all 0.
static tf_status decide_some(const tf_arithmetic *arithmetic,
                             const tf_queries *queries, size_t begin,
                             size_t end, tf_verdict verdict[],
                             size_t *separated, double clearance[])
{
    alignas(64) tf_query_block block[TF_MASK_QUERIES / TF_BLOCK_QUERIES];
    if (!tf_gather(queries, begin, end, block))
        return leave_to_reference(arithmetic, queries, begin, end, verdict,
                                  separated);
    tf_query_masks masks;
    double own[TF_MASK_QUERIES];
    size_t blocks = (end - begin + TF_BLOCK_QUERIES - 1) / TF_BLOCK_QUERIES;
    tf_lanes_filter *filter = filter_for(queries->kind);
    filter(blocks, block, share_for(arithmetic), &masks,
           clearance ? own : NULL);
    if (clearance)
        memcpy(clearance + begin, own, sizeof *own * (end - begin));
    // The last block may have places without a query.
    if (end - begin < TF_MASK_QUERIES)
        masks.undecided &= (UINT64_C(1) << (end - begin)) - 1;
    if (is_certain(arithmetic))
        decide_by_clearance(blocks, block, filter, clearance, &masks, own);
    return spread(arithmetic, queries, begin, end, &masks, verdict, separated);
}

//: Decide many queries by vectors
static tf_status decide_and_measure(void *context,
                                    const tf_arithmetic *arithmetic,
                                    const tf_queries *queries,
                                    tf_verdict verdict[], size_t *separated,
                                    double clearance[])
{
    (void)context;
    TF_REQUIRE(arithmetic && queries && separated);
    if (clearance)
        memset(clearance, 0, sizeof *clearance * queries->count);
    if (share_for(arithmetic) == 0 || !filter_for(queries->kind) ||
        !tf_environment_is_ieee())
        return tf_reference.decide(NULL, arithmetic, queries, verdict,
                                   separated);
    TF_REQUIRE((queries->vertices && verdict) || queries->count == 0);
    const tf_motion *motion = queries->motion;
    TF_REQUIRE(motion || queries->count == 0);
    size_t count = queries->count;
    tf_status status = count > 0 ? tf_motion_check(motion, 3) : TF_OK;
    if (status != TF_OK)
        return status;
    for (size_t begin = 0; begin < count; begin += TF_MASK_QUERIES) {
        size_t end =
            count - begin < TF_MASK_QUERIES ? count : begin + TF_MASK_QUERIES;
        status = decide_some(arithmetic, queries, begin, end, verdict,
                             separated, clearance);
        if (status != TF_OK)
            return status;
    }
    return TF_OK;
}

static tf_status decide_by_vectors(void *context,
                                   const tf_arithmetic *arithmetic,
                                   const tf_queries *queries,
                                   tf_verdict verdict[], size_t *separated)
{
    return decide_and_measure(context, arithmetic, queries, verdict, separated,
                              NULL);
}

const tf_narrow_phase tf_vectorized = {.name = "vector",
                                       .decide = decide_by_vectors,
                                       .measure = decide_and_measure};
