//: Declare a pool of threads
#pragma once

#include "base/api.h"
#include "base/status.h"
#include "surface/parallel.h"

/// @addtogroup pool A pool of threads
/// Declared in tanglefree_threads.h; the other groups are in tanglefree.h.
/// @{

/// The size of a pool.
enum tf_pool_size {
    TF_MOST_THREADS = 256 ///< the most threads that may run tasks
};

/// Threads that run the tasks of the library: a tf_parallel to be used as it
/// is.  They sleep while there are no tasks.  Several threads may use a pool at
/// once: their calls of `for_each` take turns.  A task that calls the `for_each`
/// of any pool runs those tasks by itself, and so does a process made by fork
/// from the one that made the pool, as its threads are not in the copy.
typedef struct tf_threads tf_threads;

//: Declare how to start threads
/// Starts the threads of a pool.  They begin with the signal mask of the calling
/// thread, and run tasks in the floating-point environment of the caller whose
/// tasks they are.  If the system refuses a thread, those started before it are
/// all of the pool.  The memory of the pool is from malloc, whatever
/// tf_set_allocator says.
///
/// @param count how many threads run tasks, the caller's own included: from 1 to
///     TF_MOST_THREADS, or 0 for the number of processors that the caller may use
/// @param[out] threads the pool, to be freed by tf_threads_free; NULL without
///     TF_OK
/// @return TF_OK, TF_BAD_OPTION if the count is out of range, or
///     TF_OUT_OF_MEMORY
TF_API tf_status tf_threads_create(int count, tf_threads **threads);

/// Ends the threads of a pool, and frees it.  No call may be using it.
/// @param threads the pool; may be NULL
TF_API void tf_threads_free(tf_threads *threads);

//: Declare how to use threads
/// What options take as `parallel`.
/// @param threads the pool; may be NULL
/// @return how to run tasks on the pool's threads, lent until it is freed; of
///     NULL, NULL: on the caller's thread alone
TF_API const tf_parallel *tf_threads_parallel(const tf_threads *threads);

/// The number of threads that run tasks, the caller's own included.
/// @param threads the pool; may be NULL
/// @return how many; 1 of NULL
TF_API int tf_threads_count(const tf_threads *threads);

/// @}
