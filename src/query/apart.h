//: Declare certain separation
#pragma once

#include "arithmetic/arithmetic.h"
#include "geometry/vector.h"

enum {
    TF_MOST_DIFFERENCES = 8 ///< of two edges, at both ends of a step
};

/// The vectors from vertices of one element to those of another: coordinate k of
/// difference i is x[k][i].
typedef struct tf_difference_list {
    int count;
    double x[TF_AXES][TF_MOST_DIFFERENCES];
    tf_vector center; ///< the mean of those that were last appended
} tf_difference_list;

/// Appends the vectors from each vertex of one element to each of another, both
/// in space: those of one time.  First x[] has the `corners` vertices of the one,
/// then the `others` of the other.
void tf_list_differences(int corners, int others, const double *const x[],
                         tf_difference_list *list);

/// Whether two elements are certainly apart along some direction, the same at
/// all times whose differences are listed, one or more.  If it is false, nothing
/// is known.  Overwrites places of the list that are not used.  In an IEEE
/// environment.
bool tf_certainly_apart(tf_difference_list *list);

//: Declare certain verdicts
/// As tf_clamped, but a narrow phase may answer TF_APART where the elements are
/// certainly apart for another reason.  Its verdicts are those of exact
/// arithmetics, or TF_UNDECIDED.
extern const tf_arithmetic tf_certain;
