//: Declare a pair of simplices
#pragma once

#include "arithmetic/differences.h"
#include "geometry/sweep.h"

enum {
    TF_PAIR_EVENTS = 6 ///< |S| + |R| = d + 2 at most, d = 4
};

/// Two simplices S and R of space-time, or of space at one time, seen on some
/// of the axes.  The events at t = 0 come first, and within each time those of
/// S.
typedef struct tf_pair {
    int count;                             ///< events of S and R together
    int start_count;                       ///< the first of them are at t = 0
    const tf_event *event[TF_PAIR_EVENTS]; ///< borrowed
    int operand[TF_PAIR_EVENTS];           ///< +1: of S, -1: of R
    int axes;                              ///< 0 to 3
    int axis[TF_AXES];                     ///< the axes not projected away
} tf_pair;

/// Makes `pair` that of two swept simplices, on the first `axes` axes (2 or 3).
void tf_pair_set(tf_pair *pair, const tf_simplex *s, const tf_simplex *r,
                 int axes);

/// The same, as a value.
tf_pair tf_pair_of(const tf_simplex *s, const tf_simplex *r, int axes);

//: Declare the determinants of a pair
/// The determinant of the pair without the event `without` (-1: all events):
/// within each time, the differences to the first event that is left.
void tf_pair_differences(const tf_pair *pair, int without,
                         tf_differences *differences);
