//: Declare the distance of two elements
#pragma once

#include "base/api.h"
#include "base/status.h"
#include "distance/nearest_points.h"
#include "query/kind.h"

#include <stdbool.h>

/// @addtogroup distances
/// @{

/// Finds how far apart two elements at rest are, for any finite doubles and
/// degenerate elements too.  The distance of elements that touch is 0.
/// Thread-safe.
///
/// @param kind of what elements
/// @param vertices how many vertices have a position
/// @param position their coordinates: three each, for TF_POINT_EDGE two
/// @param vertex the indices of the vertices of the first element, then of the
///     second
/// @param[out] nearest the answer; set only with TF_OK
/// @return TF_OK; TF_BAD_OPTION for a kind that there is not; TF_BAD_INDEX unless
///     the indices are distinct and name vertices; TF_NOT_FINITE; or
///     TF_BAD_ENVIRONMENT
TF_API tf_status tf_distance(tf_kind kind, int vertices,
                             const double position[], const int vertex[],
                             tf_nearest *nearest);

/// Decides whether two elements at rest are nearer to each other than a length:
/// exactly, where tf_distance rounds.  Thread-safe.
///
/// @param kind of what elements
/// @param vertices how many vertices have a position
/// @param position their coordinates: three each, for TF_POINT_EDGE two
/// @param vertex the indices of the vertices of the first element, then of the
///     second
/// @param length more than 0, finite
/// @param[out] nearer whether their distance is less than that; set only with
///     TF_OK
/// @return what tf_distance does, and TF_BAD_OPTION for another length
TF_API tf_status tf_is_nearer(tf_kind kind, int vertices,
                              const double position[], const int vertex[],
                              double length, bool *nearer);

/// @}
