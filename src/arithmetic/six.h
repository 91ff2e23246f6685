//: Declare six signs at once
#pragma once

#include "arithmetic/functions.h"

/// What tf_arithmetic calls `six_estimates`, for any finite coordinates.
void tf_estimate_six(int start_count, const tf_event *const event[TF_SIX],
                     tf_sign sign[TF_SIX]);
