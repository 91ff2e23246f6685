//: Declare what is known of an intersection
#pragma once

#include "intersect/signs.h"
#include "intersect/verdict.h"

/// How much of an intersection is wanted; each includes those before it.
typedef enum tf_detail {
    TF_ONLY_VERDICT, ///< verdict, classification and uniqueness
    TF_WITH_TIME,    ///< the time of impact
    TF_WITH_POINT,   ///< the barycentric coordinates
} tf_detail;

/// What is known about the earliest point that two simplices have in common.
/// Unless TF_APART, the time of that point, if there is one, is in
/// [toi_lo, toi_hi]; the width is at most 2^-50 with exact values.
typedef struct tf_intersection {
    tf_detail detail; ///< how much of the following is set
    tf_verdict verdict;
    tf_classification classification;
    bool unique; ///< certainly at most one common point: none, or some sign is
                 ///< not zero
    tf_signs signs;        ///< unless TF_DEGENERATE, the pair's
    double toi_lo, toi_hi; ///< 0 to 1
    /// Barycentric coordinates of the point, indexed by the pair's events:
    /// those of each operand are >= 0 and sum to 1 up to rounding.
    double barycentric[TF_PAIR_EVENTS];
} tf_intersection;

extern const tf_intersection tf_intersection_apart; ///< the verdict TF_APART

//: Declare the complementary test
/// Whether S and R intersect, given that they are complementary: in space-time
/// axes + 3 events, of one time axes + 2.  The signs are those of Cramer's rule
/// for the barycentric coordinates of the common point.
///
/// Returns false if all signs are certainly zero: the pair lies in a
/// hyperplane, and its signs decide nothing; *found is meaningless then.
bool tf_complementary_intersect(const tf_arithmetic *arithmetic,
                                const tf_pair *pair, tf_detail detail,
                                tf_intersection *found);

//: Declare the description of a common point
/// Adds the time, and the barycentric coordinates if they are wanted, to an
/// intersection of `pair` that tf_complementary_intersect found, unless they
/// are there already.
void tf_complementary_describe(const tf_arithmetic *arithmetic,
                               const tf_pair *pair, tf_detail detail,
                               tf_intersection *found);
