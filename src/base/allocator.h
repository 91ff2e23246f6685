//: Declare the allocator
#pragma once

#include "base/api.h"
#include "base/status.h"

#include <stddef.h>

/// @addtogroup memory Memory
/// @{

/// Allocates memory for the library.  It may be called from any thread that
/// calls the library or runs tasks of a tf_parallel, by several at once, and
/// must not call tf_set_allocator or use an object of the library.
/// @param context that of tf_set_allocator
/// @param size how many bytes, 1 or more
/// @return the memory, aligned as that of malloc is; or NULL if there is none:
///     then the library's function returns TF_OUT_OF_MEMORY
typedef void *tf_allocate_function(void *context, size_t size);

/// Frees memory that a tf_allocate_function has returned; all else that is said
/// there is true here, too.
/// @param context that of tf_set_allocator
/// @param memory the memory, not NULL
/// @param size how many bytes it was allocated with
typedef void tf_free_function(void *context, void *memory, size_t size);

//: Declare how the allocator is set
/// Replaces malloc and free for all memory of the library, in the whole program.
/// It is kept by objects from one call to the next, so these functions are called
/// rarely.  No other thread may use the library meanwhile.
/// @param allocate what allocates, or NULL with the next one to restore malloc
///     and free
/// @param release what frees
/// @param context is passed to both; borrowed
/// @return TF_OK, and the peak is 0; or TF_IN_USE if memory is in use: free all
///     objects first; then nothing is changed
TF_API tf_status tf_set_allocator(tf_allocate_function *allocate,
                                  tf_free_function *release, void *context);

/// How much memory the library's objects hold.  Thread-safe.
/// @return bytes, as they were requested of the allocator
TF_API size_t tf_memory_in_use(void);

/// The most that they have held at one time since the program began or the
/// allocator was set.  Thread-safe.
/// @return bytes
TF_API size_t tf_memory_peak(void);

/// @}
