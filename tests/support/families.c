#include "support/families.h"

#include "arithmetic/exact.h"
#include "fast/vectorized.h"
#include "query/apart.h"
#include "support/memory.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

// Families --------------------------------------------------------------------

/// A tenth of the space, and moves as long.
static query near_queries(generator *random, query_kind kind)
{
    query q = query_new(kind);
    int half = query_size(&q) / 2;
    for (int i = 0; i < half; i++) {
        double x = uniform(random, 0, 0.1);
        *query_coordinate(&q, i) = x;
        *query_coordinate(&q, i + half) = x + uniform(random, -0.1, 0.1);
    }
    return q;
}

static query lattice(generator *random, query_kind kind)
{
    return query_lattice(random, kind, 2 + below(random, 5));
}

/// A cloth at rest: flat but for rounding.
static query flat_rest(generator *random, query_kind kind)
{
    query q = query_tilted(random, kind);
    for (int v = 0; v < QUERY_VERTICES; v++)
        for (int k = 0; k < TF_AXES; k++)
            q.vertex[v].at[1].x[k] = q.vertex[v].at[0].x[k];
    return q;
}

static query scaled_by(generator *random, query q, int exponent)
{
    for (int axis = 0; axis < q.axes; axis++)
        query_scale(&q, axis, (below(random, 3) - 1) * exponent);
    return q;
}

static query scaled_axes(generator *random, query_kind kind)
{
    return scaled_by(random, query_any(random, kind), 700);
}

/// Around the ends of the range that the filter decides.
static query at_the_limits(generator *random, query_kind kind)
{
    query q = query_any(random, kind);
    return scaled_by(random, q, 295 + below(random, 10));
}

static query ulp_off(generator *random, query_kind kind)
{
    query q = query_touching(random, kind);
    query_nudge(random, &q, 1);
    return q;
}

/// Nudged integers: determinants of the size of their errors.
static query ulp_off_lattice(generator *random, query_kind kind)
{
    query q = lattice(random, kind);
    query_nudge(random, &q, 1);
    return q;
}

static query scaled_any(generator *random, query_kind kind, int exponent)
{
    query q = below(random, 2) ? query_any(random, kind)
                               : query_lattice(random, kind, 4);
    for (int axis = 0; axis < q.axes; axis++)
        query_scale(&q, axis, exponent);
    return q;
}

static query subnormal(generator *random, query_kind kind)
{
    // The coordinates themselves, or only products of three.
    int exponent = below(random, 2) ? -1070 : -365;
    return scaled_any(random, kind, exponent + below(random, 50));
}

static query huge(generator *random, query_kind kind)
{
    return scaled_any(random, kind, 990 + below(random, 30));
}

/// Neighbors in a flat sheet, sheared or not: at rest, moved as a whole, or each
/// vertex on its own way in the plane.
static query flat_grid(generator *random, query_kind kind)
{
    query q = query_new(kind);
    double shear = below(random, 5) / 4.0, drift[2] = {0, 0};
    bool rests = below(random, 3) == 0, bends = below(random, 3) == 0;
    for (int k = 0; k < 2 && !rests; k++)
        drift[k] = uniform(random, -2, 2);
    for (int v = 0; v < QUERY_VERTICES; v++) {
        double x = below(random, 4), y = below(random, 4);
        const double at[2] = {x + shear * y, y};
        for (int k = 0; k < 2; k++) {
            double bend = bends ? uniform(random, -1, 1) : 0;
            q.vertex[v].at[0].x[k] = at[k];
            q.vertex[v].at[1].x[k] = at[k] + drift[k] + bend;
        }
    }
    return q;
}

static query ulp_off_flat(generator *random, query_kind kind)
{
    query q = flat_grid(random, kind);
    query_nudge(random, &q, 1);
    for (int v = 0; v < QUERY_VERTICES; v++)
        for (int t = 0; t < 2; t++)
            q.vertex[v].at[t].x[2] = 0;
    return q;
}

/// Turns what lies in the plane z = 0 into another, by two turns.
static void turn(const double angle[2], double x[3])
{
    double y = cos(angle[0]) * x[0] - sin(angle[0]) * x[1];
    double z = sin(angle[0]) * x[0] + cos(angle[0]) * x[1];
    x[0] = cos(angle[1]) * y;
    x[1] = z;
    x[2] = sin(angle[1]) * y;
}

/// Flat but for rounding at each end, turned on the way or not.
static query flat_and_turned(generator *random, query_kind kind)
{
    query q = flat_grid(random, kind);
    double angle[2][2];
    for (int k = 0; k < 2; k++) {
        angle[0][k] = uniform(random, -4, 4);
        angle[1][k] = angle[0][k];
    }
    if (below(random, 2))
        angle[1][below(random, 2)] += uniform(random, -1, 1);
    for (int v = 0; v < QUERY_VERTICES; v++)
        for (int t = 0; t < 2; t++)
            turn(angle[t], q.vertex[v].at[t].x);
    return q;
}

const family families[FAMILIES] = {
    {"soup", query_soup},
    {"near", near_queries},
    {"lattice", lattice},
    {"tilted", query_tilted},
    {"flat at rest", flat_rest},
    {"flat", flat_grid},
    {"flat and turned", flat_and_turned},
    {"an ulp off flat", ulp_off_flat},
    {"resting", query_resting},
    {"axes scaled by 2^700", scaled_axes},
    {"axes scaled by 2^300", at_the_limits},
    {"an ulp off contact", ulp_off},
    {"an ulp off lattice", ulp_off_lattice},
    {"subnormal", subnormal},
    {"about 1e300", huge},
};

// Arrays ----------------------------------------------------------------------

batch batch_new(size_t most)
{
    batch b = {.start = allocate_lines(12 * most, sizeof(double)),
               .end = allocate_lines(12 * most, sizeof(double)),
               .vertex = allocate_lines(4 * most, sizeof(int)),
               .block = allocate_lines(most / TF_BLOCK_QUERIES + 1,
                                       sizeof(tf_query_block)),
               .masks = allocate_lines(most / TF_MASK_QUERIES + 1,
                                       sizeof(tf_query_masks))};
    for (int i = 0; i < 2; i++)
        b.verdict[i] = allocate_lines(most + 1, sizeof(tf_verdict));
    return b;
}

void batch_free(batch *b)
{
    free(b->start);
    free(b->end);
    free(b->vertex);
    free(b->block);
    free(b->masks);
    for (int i = 0; i < 2; i++)
        free(b->verdict[i]);
}

static void shuffle(generator *random, int count, int list[])
{
    for (int i = count - 1; i > 0; i--) {
        int j = below(random, i + 1), kept = list[i];
        list[i] = list[j];
        list[j] = kept;
    }
}

/// Gives the vertices of query i, which are in the order of their elements,
/// indices that keep that order, and lists these in any order.
static void add_query(batch *b, generator *random, const query *q, size_t i)
{
    int order[4] = {0, 1, 2, 3}, *listed = b->vertex + 4 * i;
    bool edges = q->vertices == 2;
    for (int v = 0; v < 4; v++) {
        for (int k = 0; k < 3; k++) {
            for (int t = 0; t < 2; t++)
                b->block[i / TF_BLOCK_QUERIES]
                    .at[t][v][k][i % TF_BLOCK_QUERIES] =
                    q->vertex[v].at[t].x[k];
            b->start[12 * i + 3 * (size_t)v + (size_t)k] =
                q->vertex[v].at[0].x[k];
            b->end[12 * i + 3 * (size_t)v + (size_t)k] =
                q->vertex[v].at[1].x[k];
        }
    }
    shuffle(random, edges ? 2 : 1, order);
    shuffle(random, edges ? 2 : 3, order + q->vertices);
    for (int v = 0; v < 4; v++)
        listed[v] = (int)(4 * i) + order[v];
}

void batch_fill(batch *b, generator *random, const family *source,
                query_kind kind, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        query q = source->make(random, kind);
        add_query(b, random, &q, i);
    }
    b->motion = (tf_motion){3, (int)(4 * count), b->start, b->end};
    b->queries = (tf_queries){.kind = kind == EDGE_EDGE ? TF_EDGE_EDGE
                                                        : TF_POINT_TRIANGLE,
                              .motion = &b->motion,
                              .count = count,
                              .vertices = b->vertex};
}

query batch_query(const batch *b, size_t i)
{
    bool edges = b->queries.kind == TF_EDGE_EDGE;
    query q = query_new(edges ? EDGE_EDGE : POINT_TRIANGLE);
    for (size_t v = 0; v < 4; v++)
        for (size_t k = 0; k < 3; k++) {
            q.vertex[v].at[0].x[k] = b->start[12 * i + 3 * v + k];
            q.vertex[v].at[1].x[k] = b->end[12 * i + 3 * v + k];
        }
    return q;
}

// Comparison ------------------------------------------------------------------

tf_status batch_filter(batch *b)
{
    return b->queries.kind == TF_EDGE_EDGE
               ? tf_filter_edge_edge(b->queries.count, b->block, b->masks)
               : tf_filter_point_triangle(b->queries.count, b->block, b->masks);
}

static tf_status decide(const tf_narrow_phase *narrow_phase, batch *b,
                        const tf_arithmetic *arithmetic, tf_verdict verdict[],
                        size_t *separated)
{
    *separated = 0;
    b->queries.motion = &b->motion;
    return narrow_phase->decide(narrow_phase->context, arithmetic, &b->queries,
                                verdict, separated);
}

/// Whether the bits of a query are consistent, and no certain one is wrong.
static bool is_right(const tf_query_masks *masks, size_t bit,
                     tf_verdict true_one)
{
    bool apart = masks->apart >> bit & 1, hit = masks->hit >> bit & 1;
    bool undecided = masks->undecided >> bit & 1;
    bool separated = masks->separated >> bit & 1;
    return apart + hit + undecided == 1 && (!separated || apart) &&
           (!apart || true_one == TF_APART) && (!hit || true_one == TF_HIT);
}

size_t batch_wrong(batch *b, size_t *undecided)
{
    size_t separated, count = b->queries.count;
    if (decide(&tf_reference, b, &tf_exact, b->verdict[0], &separated) !=
            TF_OK ||
        batch_filter(b) != TF_OK)
        return 0;
    for (size_t i = 0; i < count; i++) {
        const tf_query_masks *masks = &b->masks[i / TF_MASK_QUERIES];
        if (!is_right(masks, i % TF_MASK_QUERIES, b->verdict[0][i]))
            return i;
        *undecided += masks->undecided >> i % TF_MASK_QUERIES & 1;
    }
    return count;
}

size_t batch_different(batch *b, const tf_arithmetic *arithmetic)
{
    size_t separated[2], count = b->queries.count;
    tf_status first =
        decide(&tf_reference, b, arithmetic, b->verdict[0], &separated[0]);
    tf_status second =
        decide(&tf_vectorized, b, arithmetic, b->verdict[1], &separated[1]);
    for (size_t i = 0; i < count && first == TF_OK; i++)
        if (b->verdict[0][i] != b->verdict[1][i])
            return i;
    return first == second && separated[0] == separated[1] ? count : 0;
}

size_t batch_uncertain(batch *b)
{
    static const tf_narrow_phase *const narrow_phases[] = {&tf_reference,
                                                           &tf_vectorized};
    size_t separated, count = b->queries.count;
    if (decide(&tf_reference, b, &tf_exact, b->verdict[0], &separated) != TF_OK)
        return 0;
    for (int k = 0; k < 2; k++) {
        if (decide(narrow_phases[k], b, &tf_certain, b->verdict[1],
                   &separated) != TF_OK)
            return 0;
        for (size_t i = 0; i < count; i++)
            if (b->verdict[1][i] != TF_UNDECIDED &&
                b->verdict[1][i] != b->verdict[0][i])
                return i;
    }
    return count;
}
