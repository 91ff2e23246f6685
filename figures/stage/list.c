#include "stage/list.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

bool tf_list_room(void *items, int count, int more, int *capacity, size_t size)
{
    if (more <= *capacity - count)
        return true;
    if (more > INT_MAX / 2 - count)
        return false;
    int wanted = 2 * (count + more);
    void *old, *grown;
    memcpy(&old, items, sizeof old);
    grown = realloc(old, (size_t)wanted * size);
    if (grown == NULL)
        return false;
    memcpy(items, &grown, sizeof grown);
    *capacity = wanted;
    return true;
}

void *tf_list_copy(const void *items, int count, size_t size)
{
    size_t bytes = (size_t)count * size;
    void *copy = malloc(bytes > 0 ? bytes : 1);
    if (copy != NULL && bytes > 0)
        memcpy(copy, items, bytes);
    return copy;
}
