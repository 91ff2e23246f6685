//: Declare how to sort
#pragma once

#include "base/watch.h"
#include "surface/buffer.h"

/// Whether the item `a` comes before the item `b`.
typedef bool tf_precedes(const void *a, const void *b);

/// Sorts `count` pointers to items, equal ones in their order, from one array
/// to another with room for as many; returns the one of the two that holds the
/// result, or NULL if the caller of the watch, which may be NULL, cancels.
const void **tf_sort(size_t count, const void *from[], const void *to[],
                     tf_precedes *precedes, tf_watch *watch);

//: Declare how to sort a list
/// Memory for sorting lists, one after another.
typedef struct tf_sort_memory {
    tf_buffer pointers, items;
} tf_sort_memory;

/// Sorts a list of `count` items of `size` bytes each, equal ones in their
/// order.  False if there is no memory, or the caller of the watch, which may be
/// NULL, cancels.
bool tf_list_sort(tf_buffer *list, size_t count, size_t size,
                  tf_precedes *precedes, tf_sort_memory *memory,
                  tf_watch *watch);

size_t tf_sort_memory_bytes(const tf_sort_memory *memory);
void tf_sort_memory_free(tf_sort_memory *memory);
