//: Declare certain separation
#pragma once

#include "geometry/vector.h"
#include "query/narrow_phase.h"

enum {
    TF_MOST_DIFFERENCES = 8 ///< of two edges, at both ends of a step
};

/// The vectors from vertices of one element to those of another: coordinate k of
/// difference i is x[k][i].
typedef struct tf_difference_list {
    int count;
    double x[TF_AXES][TF_MOST_DIFFERENCES];

    // Of those that were last appended:
    int corners, others;         ///< how many vertices the elements have
    const double *const *vertex; ///< their coordinates, the caller's
    tf_vector center;            ///< the mean of the differences
} tf_difference_list;

/// Appends the vectors from each vertex of one element to each of another, both
/// in space: those of one time.  First x[] has the `corners` vertices of the one,
/// then the `others` of the other: a triangle's three, or two of each edge.  It
/// must stay as long as the list is used.
void tf_list_differences(int corners, int others, const double *const x[],
                         tf_difference_list *list);

/// Whether two elements are certainly apart along some direction, the same at
/// all times whose differences are listed, one or more.  If it is false, nothing
/// is known.  True only if no coordinate of a difference is above 2^297 in
/// absolute value.  Overwrites the places of the list that are not used.  In an
/// IEEE environment.
bool tf_certainly_apart(tf_difference_list *list);

//: Declare certain verdicts
/// Whether the elements of a query in space are certainly apart along some
/// direction.  In an IEEE environment.
bool tf_query_certainly_apart(const tf_queries *queries, size_t query);

/// As tf_clamped, but a query that certainly is apart along some direction may be
/// TF_APART: a narrow phase may look for one wherever tf_clamped is undecided.
/// Its verdicts are those of exact arithmetics, or TF_UNDECIDED.
extern const tf_arithmetic tf_certain;
