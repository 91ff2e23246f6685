//: Set an error about an intersection
#pragma once

#include "base/fail.h"
#include "surface/check.h"

/// Sets an error, unless it is NULL, to a status about two elements that
/// intersect, and returns it.
/// @param time of the step: 0 for its start; -1: there is no step
static inline tf_status tf_fail_crossing(tf_error *error, tf_status status,
                                         const tf_crossing *crossing, int time)
{
    static const tf_subject subjects[] = {
        [TF_EDGE_THROUGH_TRIANGLE] = TF_EDGE_TRIANGLE_PAIR,
        [TF_POINT_ON_TRIANGLE] = TF_POINT_TRIANGLE_PAIR,
        [TF_EDGE_ON_EDGE] = TF_EDGE_EDGE_PAIR,
    };
    return tf_fail_pair(error, status, subjects[crossing->kind], 5,
                        crossing->vertex, time);
}
