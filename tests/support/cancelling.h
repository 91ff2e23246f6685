// Calls that are cancelled at some time, and what must hold then.
#ifndef SUPPORT_CANCELLING_H
#define SUPPORT_CANCELLING_H

#include "base/error.h"
#include "base/progress.h"
#include "surgery/adaptive.h"

/// How often a progress has been told, and when it cancels.
typedef struct cancellation {
    long told;
    long last; ///< the call that cancels; 0: none does
} cancellation;

/// Cancels, with a cancellation as its context.
tf_progress tell_cancellation;

/// A long call on a surface, to be told by tell_cancellation with this context.
typedef tf_status long_call(tf_adaptive_surface *surface,
                            cancellation *cancelling, tf_error *error);

/// Cancels a call at many times, each on a new surface: expects that it then
/// tells nothing more and says so, that the surface is as it was, to the last
/// bit, with all that it lent, and that afterwards the call does the same as if
/// nothing had happened.
void expect_cancelling(tf_adaptive_surface *make(void), long_call *call,
                       long times);

#endif
