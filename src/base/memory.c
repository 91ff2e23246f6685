//: Ask for memory
#include "base/memory.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

tf_memory tf_library_memory;

static void *get_block(const tf_memory *memory, size_t size)
{
    return memory->allocate ? memory->allocate(memory->context, size)
                            : malloc(size);
}

static void put_block(const tf_memory *memory, void *block, size_t size)
{
    if (memory->release)
        memory->release(memory->context, block, size);
    else
        free(block);
}

//: Count what is in use
static void count_use(tf_memory *memory, size_t size)
{
    size_t in_use = atomic_fetch_add(&memory->in_use, size) + size;
    size_t peak = atomic_load(&memory->peak);
    while (peak < in_use &&
           !atomic_compare_exchange_weak(&memory->peak, &peak, in_use))
        ;
}

//: Allocate aligned memory
enum {
    ALIGNMENT = 64 ///< also how much more is asked for
};

/// Aligned memory begins 1 to 64 bytes after the block that it is in; the byte
/// before it says how many.
static void *align_block(unsigned char *block)
{
    unsigned char shift =
        (unsigned char)(ALIGNMENT - (uintptr_t)block % ALIGNMENT);
    block[shift - 1] = shift;
    return block + shift;
}

void *tf_allocate(size_t size)
{
    if (size > PTRDIFF_MAX - ALIGNMENT)
        return NULL;
    void *block = get_block(&tf_library_memory, size + ALIGNMENT);
    if (!block)
        return NULL;
    count_use(&tf_library_memory, size + ALIGNMENT);
    return align_block(block);
}

void *tf_allocate_zeroed(size_t size)
{
    void *memory = tf_allocate(size);
    return memory ? memset(memory, 0, size) : NULL;
}

//: Release memory
void tf_release(void *memory, size_t size)
{
    if (!memory)
        return;
    unsigned char *aligned = memory;
    put_block(&tf_library_memory, aligned - aligned[-1], size + ALIGNMENT);
    atomic_fetch_sub(&tf_library_memory.in_use, size + ALIGNMENT);
}
