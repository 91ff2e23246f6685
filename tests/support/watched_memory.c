#define _POSIX_C_SOURCE 200112L // posix_memalign

#include "support/watched_memory.h"

#include "base/allocator.h"
#include "support/support.h"

#include <stdlib.h>
#include <string.h>

enum {
    HEAD = 128 ///< room before a block, for its size and where malloc's begins
};

typedef struct head {
    size_t size;
    void *start;
} head;

static void *allocate(void *context, size_t size)
{
    watched_memory *memory = context;
    ck_assert_uint_gt(size, 0);
    memory->calls++;
    if (memory->left == 0 || (memory->most > 0 && size > memory->most))
        return NULL;
    memory->left -= memory->left > 0;
    void *all;
    ck_assert_int_eq(posix_memalign(&all, 64, HEAD + memory->offset + size), 0);
    char *start = all;
    char *block = start + HEAD + memory->offset;
    head own = {size, start};
    memcpy(block - sizeof own, &own, sizeof own);
    memset(block, 0xa5, size);
    memory->blocks++;
    memory->bytes += size;
    if (memory->bytes > memory->peak)
        memory->peak = memory->bytes;
    return block;
}

static void release(void *context, void *block, size_t size)
{
    watched_memory *memory = context;
    head own;
    ck_assert_ptr_nonnull(block);
    memcpy(&own, (char *)block - sizeof own, sizeof own);
    ck_assert_uint_eq(size, own.size);
    memory->blocks--;
    memory->bytes -= size;
    free(own.start);
}

void memory_watch(watched_memory *memory)
{
    *memory = (watched_memory){.left = -1};
    ck_assert_int_eq(tf_set_allocator(allocate, release, memory), TF_OK);
}

void memory_end(const watched_memory *memory)
{
    ck_assert_uint_eq(memory->blocks, 0);
    ck_assert_uint_eq(memory->bytes, 0);
    ck_assert_uint_eq(tf_memory_in_use(), 0);
    ck_assert_uint_eq(tf_memory_peak(), memory->peak);
    ck_assert_int_eq(tf_set_allocator(NULL, NULL, NULL), TF_OK);
}
