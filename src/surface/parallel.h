//: Declare tasks
#pragma once

#include "base/api.h"

/// @addtogroup parallel Threads
/// @{

/// One of several tasks that may run at the same time.
/// @param argument what all tasks share
/// @param task which of them, from 0
/// @param worker which of the workers runs it, from 0; a worker runs one task
///     at a time
typedef void tf_task(void *argument, int task, int worker);

//: Declare how to run tasks in parallel
/// How to run tasks on the caller's threads: by its own job system, by OpenMP,
/// or whatever else there is.  The library starts no threads.  The answers are
/// the same bits for any number of workers.
typedef struct tf_parallel {
    int workers; ///< how many tasks run at once at most, from 1 to 4096

    /// Calls `run(argument, task, worker)` for each task from 0 to count - 1,
    /// in any order, and returns when all have returned.  What a task has
    /// written must then be visible to the caller.
    void (*for_each)(void *context, int count, tf_task *run, void *argument);
    void *context; ///< passed on to `for_each`
} tf_parallel;

/// @}
