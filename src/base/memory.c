//: Count what is in use
#include "base/memory.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

tf_memory tf_library_memory;

static void count_use(size_t size)
{
    tf_memory *own = &tf_library_memory;
    size_t in_use = atomic_fetch_add(&own->in_use, size) + size;
    size_t peak = atomic_load(&own->peak);
    while (peak < in_use &&
           !atomic_compare_exchange_weak(&own->peak, &peak, in_use))
        ;
}

//: Allocate memory
void *tf_allocate(size_t size)
{
    tf_memory *own = &tf_library_memory;
    if (size > PTRDIFF_MAX)
        return NULL;
    void *memory =
        own->allocate ? own->allocate(own->context, size) : malloc(size);
    if (memory)
        count_use(size);
    return memory;
}

void *tf_allocate_zeroed(size_t size)
{
    void *memory = tf_allocate(size);
    return memory ? memset(memory, 0, size) : NULL;
}

//: Release memory
void tf_release(void *memory, size_t size)
{
    tf_memory *own = &tf_library_memory;
    if (!memory)
        return;
    if (own->release)
        own->release(own->context, memory, size);
    else
        free(memory);
    atomic_fetch_sub(&own->in_use, size);
}

//: Reallocate
static void *move_memory(void *memory, size_t size, size_t larger)
{
    void *moved = tf_allocate(larger);
    if (!moved)
        return NULL;
    if (size > 0)
        memcpy(moved, memory, size);
    tf_release(memory, size);
    return moved;
}

void *tf_reallocate(void *memory, size_t size, size_t larger)
{
    if (tf_library_memory.allocate)
        return move_memory(memory, size, larger);
    void *moved = larger > PTRDIFF_MAX ? NULL : realloc(memory, larger);
    if (moved)
        count_use(larger - size);
    return moved;
}
