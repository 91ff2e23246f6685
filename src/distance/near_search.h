//: Declare the search of near pairs
#pragma once

#include "base/error.h"
#include "distance/near_pair.h"
#include "surface/parallel.h"
#include "surface/surface_memory.h"

/// What is searched for near pairs.
typedef struct tf_near_search {
    tf_surface *surface;
    int vertices;
    const double *position;
    const double
        *before;   ///< other positions: pairs that are nearer there, too,
                   ///< are not wanted; NULL: all are
    double length; ///< more than 0, finite
    const tf_parallel *parallel;
} tf_near_search;

/// Finds the pairs that are wanted; returns what tf_surface_near does.
tf_status tf_near_search_run(const tf_near_search *search, tf_near_pairs *found,
                             tf_error *error);
