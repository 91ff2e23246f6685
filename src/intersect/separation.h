//: Declare separation by an axis
#pragma once

#include "intersect/pair.h"

#include <stdbool.h>

/// Whether S lies strictly on the same side of R along some axis at the start
/// and at the end.  Then the two do not intersect, in any arithmetic: only
/// comparisons of coordinates are made, and these are exact.
bool tf_pair_separated(const tf_pair *pair);

//: Declare the separation of elements
/// The same for two moving elements: whether one lies strictly on the same
/// side of the other, at the start and at the end, along one of the first
/// `axes` axes.  Then every pair of their simplices is separated.
bool tf_elements_separated(int axes, int vertices, const tf_worldline first[],
                           int others, const tf_worldline second[]);
