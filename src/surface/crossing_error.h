//: Declare errors about intersections
#pragma once

#include "base/error.h"
#include "surface/check.h"

/// Sets an error, unless it is NULL, to a status about two elements that
/// intersect, and returns it.
/// @param time of the step: 0 for its start; -1: there is no step
tf_status tf_fail_crossing(tf_error *error, tf_status status,
                           const tf_crossing *crossing, int time);
