//: Declare the time of impact
#pragma once

#include "intersect/coordinates.h"

/// An interval that contains a time of the step: 0 <= lo <= hi <= 1.
typedef struct tf_interval {
    double lo, hi;
} tf_interval;

/// The operand with fewer events, +1 or -1: at most three, and at most two of
/// them at one time.  The enclosure of the time relies on that.
int tf_pair_smaller_operand(const tf_pair *pair);

/// The time of the common point of a pair, from the coordinates of its smaller
/// operand.  With exact values at most 2^-50 wide.
tf_interval tf_pair_time(const tf_pair *pair,
                         const tf_coordinates *coordinates);
