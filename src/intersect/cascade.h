//: Declare the earlier of two intersections
#pragma once

#include "intersect/complementary.h"

/// The earlier of the first common points of two pairs, from what is known
/// about each.
/// Barycentric coordinates are those of the one that may come first; `a` in a
/// tie.
tf_intersection tf_intersection_earlier(const tf_intersection *a,
                                        const tf_intersection *b);

//: Declare the intersection of two swept simplices
/// The verdict and the earliest point of two closed simplices that both span
/// t = 0 to t = 1, with axes + 3 events, degenerate in any way.  Exact when the
/// signs are; with unknown signs TF_UNDECIDED, never TF_APART, where a contact
/// is possible.
tf_intersection tf_intersect(const tf_arithmetic *arithmetic,
                             const tf_pair *pair, tf_detail detail);

/// Adds the time, and the barycentric coordinates if they are wanted, to what
/// tf_intersect found for a pair that is not apart.
void tf_intersection_describe(const tf_arithmetic *arithmetic,
                              const tf_pair *pair, tf_detail detail,
                              tf_intersection *found);
