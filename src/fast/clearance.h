//: Measure along a direction
#pragma once

#include "fast/determinants.h"

#include <stdbool.h>

/// The ranges of the two elements along a direction, at one time.
typedef struct tf_lane_extents {
    tf_lane_range first, second;
} tf_lane_extents;

/// Relative to the last vertex, so that the error does not grow with the distance
/// from the origin.
TF_ALWAYS_INLINE tf_lane_extents tf_lane_extents_along(const tf_vector x[4],
                                                       tf_vector along,
                                                       bool of_edges)
{
    double a = tf_vector_dot(tf_vector_difference(x[0], x[3]), along);
    double b = tf_vector_dot(tf_vector_difference(x[1], x[3]), along);
    double c = tf_vector_dot(tf_vector_difference(x[2], x[3]), along);
    tf_lane_range c_and_d = tf_lane_range_of(c, 0);
    if (of_edges)
        return (tf_lane_extents){tf_lane_range_of(a, b), c_and_d};
    return (tf_lane_extents){{a, a},
                             tf_lane_union(tf_lane_range_of(b, b), c_and_d)};
}

//: Find the clearance along a direction
/// The largest coordinate, in absolute value.
TF_ALWAYS_INLINE double tf_lane_norm(tf_vector v)
{
    return tf_most(tf_most(tf_most(v.x[0], -v.x[0]), tf_most(v.x[1], -v.x[1])),
                   tf_most(v.x[2], -v.x[2]));
}

/// How far the elements are apart along a direction, on the same sides at the
/// start and at the end; not greater than 0 if they are not.
TF_ALWAYS_INLINE double tf_lane_clearance_along(const tf_lane *lane,
                                                tf_vector along, bool of_edges)
{
    tf_lane_extents at_start =
        tf_lane_extents_along(lane->start, along, of_edges);
    tf_lane_extents at_end = tf_lane_extents_along(lane->end, along, of_edges);
    tf_lane_gaps start = tf_lane_gaps_of(at_start.second, at_start.first);
    tf_lane_gaps end = tf_lane_gaps_of(at_end.second, at_end.first);
    double gap = tf_most(tf_least(start.beyond, end.beyond),
                         tf_least(start.before, end.before));
    // What products lose where they underflow is far less than this.
    const double least = 0x1p-1000;
    return (gap - least) / (tf_lane_norm(along) + least);
}

//: Choose directions
/// The direction in which the elements lie one above the other at the end: that
/// of the triangle's normal, or across both edges.
TF_ALWAYS_INLINE tf_vector tf_lane_across(const tf_vector x[4], bool of_edges)
{
    tf_vector first = tf_vector_difference(x[1], x[of_edges ? 0 : 3]);
    return tf_vector_cross(first, tf_vector_difference(x[2], x[3]));
}

/// The direction in which they lie side by side at the end: from the center of
/// one toward that of the other, three times for a triangle, twice for edges.
TF_ALWAYS_INLINE tf_vector tf_lane_toward(const tf_vector x[4], bool of_edges)
{
    tf_vector u = tf_vector_difference(x[1], x[0]);
    tf_vector v = tf_vector_difference(x[2], x[0]);
    tf_vector w = tf_vector_difference(x[3], x[0]);
    tf_vector sum = tf_vector_sum(v, of_edges ? -1 : 1, u);
    return tf_vector_sum(sum, 1, w);
}

//: Find the clearance of two elements
/// How far the ends of their vertices may move before the elements could meet, as
/// the narrow phase measures it; 0 if that is not known.
///
/// A movement of |dx| + |dy| + |dz| changes a number along a direction by at most
/// that times the direction's largest coordinate, its norm.  The coordinates of
/// the difference of two vertices add up to at most twice the reach, and no term
/// of a number goes through more than four roundings.  So with u = 2^-53 a number
/// errs by about 8 u times reach times norm, a gap by twice as much, and the
/// quotient, with roundings of its own, by less than 32 u times the reach, which
/// is far less than what is taken off.
TF_ALWAYS_INLINE double tf_lane_clearance(const tf_lane *lane,
                                          const tf_lane_evidence *shown,
                                          bool of_edges)
{
    double across = tf_lane_clearance_along(
        lane, tf_lane_across(lane->end, of_edges), of_edges);
    double toward = tf_lane_clearance_along(
        lane, tf_lane_toward(lane->end, of_edges), of_edges);
    double error = 0x1p-40 * shown->reach;
    double most = tf_most(across, tf_most(toward, shown->gap)) - error;
    // Negative if products may overflow, and a NaN if a coordinate is not finite:
    // as the second operand it survives the minimum, and then 0 is the greater.
    double nothing = shown->sum - shown->sum;
    double known = 0x1p300 - (shown->reach + nothing);
    return tf_most(tf_least(most, known), 0);
}
