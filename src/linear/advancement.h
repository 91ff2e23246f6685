//: Declare how far to advance
#pragma once

#include "base/api.h"

#include "intersect/verdict.h"

/// @addtogroup study
/// @{

/// When advancement ends: as soon as the elements are at most a target distance
/// apart, the larger of `threshold` and `fraction` times their distance at the
/// start.  Each step spends all of the distance but half the target, so
/// rounding cannot carry the elements through each other as long as the target
/// is large beside the roundoff of a coordinate.
typedef struct tf_advance_limits {
    double threshold; ///< finite, at least 0, in units of length
    double fraction;  ///< 0 or more, below 1; Li et al. use 0.1
    int steps;        ///< the most steps, 0 or more; 0: 10,000
} tf_advance_limits;

/// How far the elements have been advanced.
typedef struct tf_advancement {
    tf_verdict verdict; ///< TF_HIT: the target distance was reached; TF_APART:
                        ///< the end of the step was, at a greater distance;
                        ///< TF_UNDECIDED: the steps are used up
    int steps;          ///< how many were made
    double time;        ///< up to here the elements do not touch, 0 to 1
    double distance;    ///< at that time, in units of length
    double barycentric[2][3]; ///< of the points of the first and the second
                              ///< element that are nearest at that time
} tf_advancement;

/// @}
