#include "renderer/list.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

/// Give a list room for `wanted` items.
static bool resize(void *items, int wanted, int *capacity, size_t size)
{
    void *old, *grown;
    memcpy(&old, items, sizeof old);
    grown = realloc(old, (size_t)wanted * size);
    if (grown == NULL)
        return false;
    memcpy(items, &grown, sizeof grown);
    *capacity = wanted;
    return true;
}

bool fig_list_room(void *items, int count, int more, int *capacity, size_t size)
{
    if (more <= *capacity - count)
        return true;
    return more <= INT_MAX / 2 - count &&
           resize(items, 2 * (count + more), capacity, size);
}

bool fig_list_more(void *items, int count, int more, int *capacity, size_t size)
{
    if (more <= *capacity - count)
        return true;
    return more <= INT_MAX - count &&
           resize(items, count + more, capacity, size);
}

void *fig_list_copy(const void *items, int count, size_t size)
{
    size_t bytes = (size_t)count * size;
    void *copy = malloc(bytes > 0 ? bytes : 1);
    if (copy != NULL && bytes > 0)
        memcpy(copy, items, bytes);
    return copy;
}
