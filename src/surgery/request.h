//: Declare the check of a request
#pragma once

#include "base/status.h"
#include "surgery/adaptive_surface.h"
#include "surgery/outcome.h"

/// Begins an operation on one vertex or two; `position` may be NULL.  Returns
/// TF_OK, TF_BAD_ENVIRONMENT, TF_BAD_INDEX or TF_NOT_FINITE.
tf_status tf_request_check(const tf_adaptive_surface *surface, int a, int b,
                           const double position[], tf_outcome *outcome);
