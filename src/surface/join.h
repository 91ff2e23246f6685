//: Declare the join of two trees
#pragma once

#include "surface/candidate.h"
#include "surface/tree.h"

enum {
    TF_BATCH = 4096 ///< pairs handed on at once
};

/// Where pairs go.
typedef struct tf_pair_sink tf_pair_sink;
struct tf_pair_sink {
    /// Takes the pairs; false: no more are wanted.
    bool (*take)(tf_pair_sink *sink, int count, const tf_candidate pair[]);

    /// Drops some of the pairs before they are taken; NULL: none are dropped.
    void (*filter)(tf_pair_sink *sink);
    const void *filter_job; ///< for `filter`
    int count;
    bool stopped;
    tf_candidate pair[TF_BATCH];
};

/// Hands on the pairs that the sink has, unless it is stopped.
void tf_pair_sink_hand_on(tf_pair_sink *sink);

//: Declare the join of leaves
enum {
    TF_JOIN_PART = 64 ///< leaves a task of a join has
};

/// Finds the pairs of an element of `s` in the given leaves and an element of
/// `t`, or, if both are the same tree, each such pair of two elements once.  The
/// elements of `s` are vertices or edges.  Stops early if the sink is stopped,
/// and hands on what is left.
void tf_tree_join(const tf_tree *s, const tf_tree *t, tf_range leaves,
                  tf_pair_sink *sink);
