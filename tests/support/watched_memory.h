// The library's memory, watched by a test that uses one thread.
#ifndef SUPPORT_WATCHED_MEMORY_H
#define SUPPORT_WATCHED_MEMORY_H

#include <stddef.h>

/// What an allocator has done since it was set.
typedef struct watched_memory {
    long calls;           ///< for memory
    long left;            ///< how many more of them have some; below 0: all
    size_t most;          ///< a block of more bytes is refused; 0: none is
    size_t blocks, bytes; ///< in use
    size_t peak;          ///< of the bytes
    size_t offset;        ///< of the blocks that will be allocated, from a
                          ///< multiple of 64; itself one of 16, below 64
} watched_memory;

/// Sets an allocator that expects what tf_set_allocator promises.  It ends each
/// block where an address sanitizer notices the first byte after it.
void memory_watch(watched_memory *memory);

/// Expects that all is freed, and restores malloc and free.
void memory_end(const watched_memory *memory);

#endif
