//: Declare all passes of a reconnection
#pragma once

#include "base/error.h"
#include "topology/reconnector.h"

/// Reads options, and scales their lengths to the unit in
/// which the surface is measured.  Sets the error to what it returns:
/// TF_OK or TF_BAD_OPTION.
tf_status tf_reconnect_options_read(tf_reconnect_options *own,
                                    const tf_reconnect_options *options,
                                    double scale, tf_reconnect_lengths *lengths,
                                    tf_error *error);

/// Merges, pinches and drops, with the lengths of the reconnector and in its
/// memory, and makes a new report.  Returns TF_OK, TF_OUT_OF_MEMORY or
/// TF_CANCELLED.
tf_status tf_reconnect_passes(tf_reconnector *reconnector);
