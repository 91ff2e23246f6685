//: Declare the steps of advancement
#pragma once

#include "linear/advancement.h"
#include "linear/distance.h"

/// Two moving elements.
typedef struct tf_approach {
    const void *motion;
    int vertices, others;

    /// The vertices at a time, those of the first element first.
    void (*positions)(const void *motion, double time, tf_vector x[]);

    /// No less than the speed at which the elements can approach each other
    /// from a time on, given what is nearest then; negative if they part.
    double (*speed)(const void *motion, double time, const tf_vector x[],
                    const tf_point_pair *nearest);
} tf_approach;

/// Whether limits are in their ranges.
bool tf_advance_limits_valid(const tf_advance_limits *limits);

/// Advances the elements, step by step, until they are near, the time is up or
/// the steps are.
tf_advancement tf_advance(const tf_advance_limits *limits,
                          const tf_approach *approach);
