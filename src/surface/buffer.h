//: Declare memory that is kept
#pragma once

#include <stdbool.h>
#include <stddef.h>

/// Memory that is kept from one call to the next.  All zero: none yet.
typedef struct tf_buffer {
    void *data;
    size_t bytes;
    size_t shift; ///< how far after the beginning of what was allocated the
                  ///< data is, 1 to 64 bytes; 0: there, not aligned for vectors
} tf_buffer;

/// Makes room for `count` items of `size` bytes each, aligned for vectors of 64
/// bytes.  What the buffer held is lost if it has to grow.  False if there is
/// no memory; the buffer then is as it was.
bool tf_buffer_reserve(tf_buffer *buffer, size_t count, size_t size);

/// Makes room for a list that is added to: what the buffer held stays, and the
/// room at least doubles if it has to grow.  It is aligned like that of malloc,
/// and no more; so a buffer is used with one of these two functions only.
bool tf_buffer_extend(tf_buffer *buffer, size_t count, size_t size);

void tf_buffer_free(tf_buffer *buffer);
