//: Declare a clear fraction of a step
#pragma once

#include "base/api.h"
#include "base/status.h"
#include "response/options.h"
#include "response/resolver.h"

/// @addtogroup response
/// @{

/// Finds the largest of the fractions 1, 1/2, 1/4, ... of a step that is clear.
///
/// A shorter step is another step, because its elements bend differently on the
/// way.  So each fraction is rounded to doubles and tested by itself, and the
/// time of the first contact says little about the answer.
///
/// @param resolver the resolver of the surface
/// @param vertices how many vertices have positions
/// @param start where they start, `axes` coordinates each; free of intersections
/// @param[in,out] end in: where they should end; out, only with TF_OK: start +
///     2^-k (end - start), rounded, such that no two elements meet on the way
/// @param options only check_start, narrow_phase, parallel, progress, context
///     and zone are used; NULL: all zero
/// @param[out] halvings the least such k; or -1 if nothing moves any more, and
///     `end` equals `start`
/// @param[out] error what is wrong, if anything; may be NULL
/// @return TF_OK; TF_BAD_COUNT; TF_BAD_OPTION; TF_NOT_FINITE;
///     TF_START_NOT_CLEAR; TF_BAD_ENVIRONMENT; TF_OUT_OF_MEMORY; or TF_CANCELLED,
///     and then the resolver and its surface are as good as new
TF_API tf_status tf_step_limit(tf_resolver *resolver, int vertices,
                               const double start[], double end[],
                               const tf_response_options *options,
                               int *halvings, tf_error *error);

/// @}
