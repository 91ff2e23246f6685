// Watches over calls that tests make.
#ifndef SUPPORT_WATCHES_H
#define SUPPORT_WATCHES_H

#include "base/watch.h"

/// A watch, and the caller who is told.
typedef struct watched_call {
    tf_watch watch;
    long calls, last; ///< so far, and the one that cancels; 0: none
    size_t work;      ///< units that were done when the caller cancelled
} watched_call;

/// Begins to watch, and returns the watch.  `last` -1: cancelled already.
tf_watch *watched_begin(watched_call *call, long last);

/// How many units of work were done in all, or since the caller cancelled.
size_t watched_work(watched_call *call);
size_t watched_work_after(watched_call *call);

#endif
