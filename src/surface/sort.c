//: Merge two runs
#include "surface/sort.h"

#include <string.h>

enum {
    WATCHED = 1024 ///< items that are merged before the caller is told
};

/// Merges from[begin..middle - 1] and from[middle..end - 1] into `to`.  False if
/// the caller cancels.
static bool merge(const void *from[], size_t begin, size_t middle, size_t end,
                  const void *to[], tf_precedes *precedes, tf_watch *watch)
{
    size_t a = begin, b = middle;
    for (size_t i = begin; i < end; i++) {
        bool second = b < end && (a == middle || precedes(from[b], from[a]));
        to[i] = second ? from[b++] : from[a++];
        if (i % WATCHED == WATCHED - 1 && !tf_watch_done(watch, 0))
            return false;
    }
    return true;
}

//: Sort by merging
const void **tf_sort(size_t count, const void *from[], const void *to[],
                     tf_precedes *precedes, tf_watch *watch)
{
    for (size_t width = 1; width < count; width *= 2) {
        for (size_t begin = 0; begin < count; begin += 2 * width) {
            size_t rest = count - begin;
            size_t middle = rest < width ? count : begin + width;
            size_t end = rest < 2 * width ? count : begin + 2 * width;
            if (!merge(from, begin, middle, end, to, precedes, watch))
                return NULL;
        }
        const void **swap = from;
        from = to;
        to = swap;
    }
    return from;
}

//: Sort a list
bool tf_list_sort(tf_buffer *list, size_t count, size_t size,
                  tf_precedes *precedes, tf_sort_memory *memory,
                  tf_watch *watch)
{
    if (!tf_buffer_extend(&memory->pointers, 2 * count + 1, sizeof(void *)) ||
        !tf_buffer_extend(&memory->items, count, size))
        return false;
    const void **pointer = memory->pointers.data;
    for (size_t i = 0; i < count; i++)
        pointer[i] = (const char *)list->data + size * i;
    pointer = tf_sort(count, pointer, pointer + count, precedes, watch);
    if (!pointer)
        return false;
    for (size_t i = 0; i < count; i++)
        memcpy((char *)memory->items.data + size * i, pointer[i], size);
    tf_buffer swap = *list;
    *list = memory->items;
    memory->items = swap;
    return true;
}

//: Keep the memory for sorting
size_t tf_sort_memory_bytes(const tf_sort_memory *memory)
{
    return memory->pointers.bytes + memory->items.bytes;
}

void tf_sort_memory_free(tf_sort_memory *memory)
{
    tf_buffer_free(&memory->pointers);
    tf_buffer_free(&memory->items);
}
