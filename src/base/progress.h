//: Declare the progress of a long call
#pragma once

#include "base/api.h"

#include <stdbool.h>
#include <stddef.h>

/// @addtogroup progress Progress
/// @{

/// How far a long call has come.  Later versions may add members to its end.
typedef struct tf_stage {
    const char
        *name;    ///< what is being done, one or two words in static storage
    size_t done;  ///< how much of it
    size_t total; ///< of how much; 0: that is not known
} tf_stage;

/// Called now and then by a long call, at least every few milliseconds.  It may
/// be called from any thread that runs tasks of a tf_parallel, but by one at a
/// time.  It must not use the object that the call works on.
/// @param context that of the options
/// @param stage how far the call has come, lent until this function returns
/// @return whether to go on; false: the call ends within a tenth of a second
///     with TF_CANCELLED, and has changed nothing
typedef bool tf_progress(void *context, const tf_stage *stage);

/// @}
