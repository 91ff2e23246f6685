//: Declare where memory comes from
#pragma once

#include <stdatomic.h>
#include <stddef.h>

/// Where the library's memory comes from, and how much of it there is.  The
/// functions are those of tf_set_allocator, or NULL for malloc and free.
typedef struct tf_memory {
    void *(*allocate)(void *context, size_t size);
    void (*release)(void *context, void *memory, size_t size);
    void *context;
    atomic_size_t in_use, peak; ///< bytes
} tf_memory;

/// That of the whole library.
extern tf_memory tf_library_memory;

//: Declare how memory is allocated
/// Allocates memory, one byte or more, aligned as that of malloc is.  NULL if
/// there is none, or if it is more than any object may have.
void *tf_allocate(size_t size);

/// The same, all zero.
void *tf_allocate_zeroed(size_t size);

/// Enlarges memory, which is NULL for a size of 0, and keeps what it holds; it
/// may move.  NULL if there is none; it is as it was then.
void *tf_reallocate(void *memory, size_t size, size_t larger);

/// Releases memory of the size that it was given last; it may be NULL.
void tf_release(void *memory, size_t size);
