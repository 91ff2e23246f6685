// How soon a long call ends when its caller cancels it.
#ifndef BENCH_LATENCY_H
#define BENCH_LATENCY_H

#include "base/progress.h"
#include "base/status.h"
#include "surface/parallel.h"

/// A call that is watched.
typedef struct watched {
    const tf_parallel *parallel;
    tf_progress *progress;
    void *context;
} watched;

/// A long call of the library.
typedef struct long_call {
    const char *name;
    int variant; ///< for `make` and `run`

    /// Makes what it works on, to be freed by `release`.
    void *(*make)(int variant);
    void (*release)(void *scene);

    /// Calls the library.
    tf_status (*run)(void *scene, int variant, const watched *how);
} long_call;

/// How the calls are measured.
typedef struct latency_plan {
    int moments;                 ///< at which each is cancelled, at random
    double seconds;              ///< of each that count at most
    const tf_parallel *parallel; ///< NULL: by processor time, else by the clock
} latency_plan;

/// Prints a line a call: its name; its seconds, or the most that count; calls of
/// the callback; milliseconds without one, at most, and the stage; and the
/// milliseconds from the callback's false to the return: half of them, nine
/// tenths and all were no longer than these.  Then the stage of the longest.
void latency_print(const long_call *call, const latency_plan *plan);

#endif
