//: Declare all passes of a reconnection
#pragma once

#include "base/status.h"
#include "topology/reconnector.h"

/// Merges, pinches and drops, in memory that is kept.  Returns what
/// tf_adaptive_reconnect does.
/// @param[in,out] report what was done is added to it
tf_status tf_reconnect_passes(tf_reconnector *reconnector,
                              const tf_reconnect_options *options,
                              tf_reconnect_report *report);
