//: Declare a surface that is being untangled
#pragma once

#include "base/error.h"
#include "base/watch.h"
#include "surface/check.h"
#include "surface/pair_cache.h"
#include "untangle/neighbors.h"
#include "untangle/patch.h"

/// A surface that is being untangled, in coordinates that are scaled such that
/// the largest is from 1 to 2.
typedef struct tf_tangle {
    tf_surface *surface;
    const tf_parallel *parallel;
    tf_watch *watch; ///< of the call, or NULL
    tf_neighbors near;
    const bool *fixed;      ///< of each vertex
    const double *in;       ///< where the vertices were
    double edge;            ///< the mean length of the edges of `in`
    double *edge_at;        ///< of each vertex: that of its edges
    tf_crossings crossings; ///< of the last check
    tf_pair_cache pairs;    ///< of the last limit
    tf_near_patch patch;    ///< of the last limit
    tf_buffer lengths, moves;
    tf_buffer listed, merged; ///< crossings
} tf_tangle;

/// Finds what is needed of the surface; false if there is no memory.  The
/// members before `near`, and `fixed` and `in`, are the caller's.
bool tf_tangle_begin(tf_tangle *tangle);

void tf_tangle_end(tf_tangle *tangle);

//: Declare how a tangle is checked
/// Finds the crossings at x.
tf_status tf_tangle_check(tf_tangle *tangle, const double x[]);

/// The same after the last limit's moves from `from` to x, where the crossings
/// at `from` are those of the last check: only what has moved is looked at.
tf_status tf_tangle_follow(tf_tangle *tangle, const double from[],
                           const double x[]);

/// How many of them are of fixed vertices alone.
size_t tf_tangle_beyond(const tf_tangle *tangle);

/// How many vertices a crossing has.
int tf_crossing_corners(const tf_crossing *crossing);

/// Whether all vertices of an element, edge or facet, are fixed.
bool tf_are_fixed(const tf_tangle *tangle, int corners, const int corner[]);
