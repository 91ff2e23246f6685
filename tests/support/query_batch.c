#include "support/query_batch.h"

#include "arithmetic/exact.h"
#include "fast/vectorized.h"
#include "query/apart.h"
#include "support/memory.h"

#include <stdbool.h>
#include <stdlib.h>

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
