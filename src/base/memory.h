//: Declare where memory comes from
#pragma once

#include <stdatomic.h>
#include <stddef.h>

/// Where the library's memory comes from, and how much of it there is.  The
/// functions are those of tf_set_allocator; without them it is malloc's.
typedef struct tf_memory {
    void *(*allocate)(void *context, size_t size);
    void (*release)(void *context, void *memory, size_t size);
    void *context;
    atomic_size_t in_use, peak; ///< bytes
} tf_memory;

/// The one that all of the library uses.
extern tf_memory tf_library_memory;

//: Declare how memory is allocated
/// Allocates memory that is aligned for vectors of 64 bytes.  Returns NULL if
/// there is none, or if no object can be so large.
void *tf_allocate(size_t size);

/// The same, all zero.
void *tf_allocate_zeroed(size_t size);

/// Releases memory of the size that it was allocated with, or NULL.
void tf_release(void *memory, size_t size);
