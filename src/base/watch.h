//: Declare the watch over a long call
#pragma once

#include "base/progress.h"
#include "base/status.h"

#include <stdatomic.h>

/// What a long call tells its caller, and whether the caller has cancelled it.
/// Any number of threads may use one.  A call that is not watched has NULL.
typedef struct tf_watch {
    tf_progress *progress;
    void *context;
    tf_stage stage;
    atomic_size_t done; ///< of the stage
    atomic_size_t work; ///< of the call, in units
    atomic_bool cancelled;
    atomic_flag told; ///< a thread is telling the caller
} tf_watch;

/// Begins to watch a call; returns the watch, or NULL if there is no callback.
tf_watch *tf_watch_begin(tf_watch *watch, tf_progress *progress, void *context);

/// Begins a stage; not while other threads use the watch.
void tf_watch_stage(tf_watch *watch, const char *name, size_t total);

/// Notes that more of the stage is done, and tells the caller; false if the
/// caller has cancelled.  Costs about as much as the callback; so it is called
/// once for some microseconds of work, and at least every 10 milliseconds.
bool tf_watch_done(tf_watch *watch, size_t more);

/// The same, but does not tell the caller.
void tf_watch_advance(tf_watch *watch, size_t more);

/// Whether the caller has cancelled.
bool tf_watch_cancelled(tf_watch *watch);

/// Why something failed that fails if the caller has cancelled or if there is no
/// memory.
tf_status tf_watch_failure(tf_watch *watch);

//: Declare the watch over loops
enum {
    TF_WATCHED_WORK = 4096 ///< units after which the caller is told
};

/// Counts work, and tells the caller now and then.
bool tf_watch_count(tf_watch *watch, size_t units);

/// Notes that a loop does some more units of work, each of about 50 nanoseconds;
/// false if the caller has cancelled, and then for good.
static inline bool tf_watch_work(tf_watch *watch, size_t units)
{
    return !watch || tf_watch_count(watch, units);
}
