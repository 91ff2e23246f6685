// Many queries of a family at once, as arrays.
#ifndef SUPPORT_QUERY_BATCH_H
#define SUPPORT_QUERY_BATCH_H

#include "fast/block_filter.h"
#include "query/narrow_phase.h"
#include "support/families.h"

/// Many queries, each with vertices of its own, in a random order of indices.
/// TF_POINT_TRIANGLE or TF_EDGE_EDGE.
typedef struct batch {
    tf_queries queries;
    tf_motion motion;
    double *start, *end;
    int *vertex;
    tf_query_block *block; ///< the same queries, element by element in order
    tf_query_masks *masks; ///< room for the verdicts
    tf_verdict *verdict[2];
} batch;

/// Room for up to `most` queries.
batch batch_new(size_t most);
void batch_free(batch *b);

/// Fills it with `count` queries.
void batch_fill(batch *b, generator *random, const family *source,
                query_kind kind, size_t count);

/// The filter of the kind.
tf_status batch_filter(batch *b);

/// Which query has another certain verdict in the masks than by exact signs;
/// the count if none has.  Counts those that are undecided.
size_t batch_wrong(batch *b, size_t *undecided);

/// Which query has another verdict by vectors; the count if none has.
size_t batch_different(batch *b, const tf_arithmetic *arithmetic);

/// Which query has a verdict of tf_certain that is neither TF_UNDECIDED nor the
/// one by exact signs, by vectors or by the reference; the count if none has.
size_t batch_uncertain(batch *b);

/// The query i, for a message.
query batch_query(const batch *b, size_t i);

#endif
