//: Declare how a surgery is tried
#pragma once

#include "surgery/adaptive_surface.h"
#include "surgery/outcome.h"

/// Tries the surgery: what the first test to refuse it says, or TF_COMMITTED if
/// none does.  Changes nothing.
tf_outcome tf_surgery_try(tf_adaptive_surface *surface);
