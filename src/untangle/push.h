//: Declare the push
#pragma once

#include "untangle/breaches.h"
#include "untangle/change.h"

/// Memory for pushing wrong regions out, and what is known of them.
typedef struct tf_push {
    bool acute; ///< whether to look for a region's way out on the acute side of
                ///< a curve, too
    tf_curves curves;
    tf_regions regions;
    tf_breaches breaches;
    int *preferred; ///< of each part: see tf_regions_find
    int *stamp;     ///< of each facet: the last region that it is tried for
    int *target;    ///< the facets that are tried for a region
    int targets;
    tf_buffer storage;
} tf_push;

/// Begins with no preferences; false if there is no memory.
bool tf_push_begin(tf_push *push, const tf_tangle *tangle);

void tf_push_free(tf_push *push);

/// Finds the wrong regions of the tangle at x, and proposes to push their vertices
/// through the facets that they have passed: each to the nearest facet, which
/// comes half of the way.  Where a curve cuts nothing, proposes to shorten it.
/// False if there is no memory, or if the caller cancels.
bool tf_push_propose(tf_push *push, const tf_tangle *tangle, const double x[],
                     tf_change *change);
