//: Declare complementary simplices
#ifndef TF_SPACETIME_COMPLEMENTARY_H
#define TF_SPACETIME_COMPLEMENTARY_H

#include "arithmetic/differences.h"
#include "spacetime/sweep.h"

#include <stdbool.h>

//: Declare a pair of simplices
enum {
    TF_PAIR_EVENTS = 6
}; ///< |S| + |R| = d + 2 at most, d = 4

/// Two simplices S and R of space-time, or of space at one time, seen on some
/// of the axes.  The events at t = 0 come first, and within each time those of
/// S.
typedef struct tf_pair {
    int count;                             ///< events of S and R together
    int early;                             ///< the first `early` are at t = 0
    const tf_event *event[TF_PAIR_EVENTS]; ///< borrowed
    int side[TF_PAIR_EVENTS];              ///< +1: of S, -1: of R
    int axes;                              ///< 0 to 3
    int axis[TF_AXES];                     ///< the axes not projected away
} tf_pair;

/// The pair of two swept simplices, on the first `axes` axes (2 or 3).
tf_pair tf_pair_of(const tf_simplex *s, const tf_simplex *r, int axes);

//: Declare what two simplices do
typedef enum tf_verdict {
    TF_UNDECIDED = 0, ///< the signs are not known well enough to exclude a hit
    TF_APART,         ///< the closed simplices have no point in common
    TF_HIT,           ///< they have
} tf_verdict;

/// How a verdict was found.
typedef enum tf_decision {
    TF_GENERIC = 0, ///< by barycentric signs, none of them zero
    TF_TOUCHING,    ///< by barycentric signs, some zero or not known
    TF_DEGENERATE,  ///< all signs are zero: by lower dimensions
} tf_decision;

/// What is known of the earliest point that two simplices have in common.
/// Unless TF_APART, the time of that point, if there is one, is in
/// [toi_lo, toi_hi]; the width is at most 2^-50 with exact values.
typedef struct tf_meeting {
    tf_verdict verdict;
    tf_decision decision;
    bool unique; ///< some sign is certainly not zero: at most one common point
    double toi_lo, toi_hi; ///< 0 to 1
    /// Barycentric weights of the point, by the pair's events: those of each
    /// side are >= 0 and sum to 1 up to rounding.
    double weight[TF_PAIR_EVENTS];
} tf_meeting;

extern const tf_meeting tf_meeting_apart; ///< the verdict TF_APART

//: Declare the complementary test
/// The determinant of the pair without the event `without` (-1: all events):
/// within each time, the differences to the first event that is left.
tf_differences tf_pair_differences(const tf_pair *pair, int without);

/// Whether S and R meet, given that they are complementary: in space-time
/// axes + 3 events, of one time axes + 2.  The signs are those of Cramer's rule
/// for the barycentric coordinates of the common point.
///
/// Returns false, with *meeting unset, if all signs are certainly zero: the
/// pair lies in a hyperplane, and its signs tell nothing.
bool tf_complementary_meet(const tf_arithmetic *arithmetic, const tf_pair *pair,
                           tf_meeting *meeting);

//: Declare how values are scaled
/// Divide values by one power of two, so that the largest comes near 1, and
/// leave them with the exponent and the order zero: an infinitely smaller one
/// becomes zero.  Where digits fall below the least double, a radius that is
/// not zero grows by it.  Values that are not known stay NaN or infinite; if none
/// is known to be not zero, all stay as they are.
void tf_values_scale(int count, tf_value value[]);

//: Close complementary simplices
#endif
