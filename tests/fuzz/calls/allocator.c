#include "allocator.h"

#include "arguments.h"

#include <stdlib.h>
#include <string.h>

enum {
    HEADER = 16,    ///< bytes before each allocation, which hold its size
    MOST = 64 << 20 ///< bytes: more are refused
};

typedef struct memory {
    long allocations;
    size_t in_use;
    int left;   ///< allocations until one fails; negative: none does
    bool again; ///< whether all fail from then on
    bool failed;
} memory;

static memory own = {.left = -1};

// The allocator ---------------------------------------------------------------

static bool fails(memory *all, size_t size)
{
    bool now = all->left == 0 || size > MOST;
    if (all->left > 0 || (now && !all->again))
        all->left--;
    all->failed |= now;
    return now;
}

static void *allocate(void *context, size_t size)
{
    memory *all = context;
    all->allocations++;
    if (size == 0)
        abort();
    if (fails(all, size))
        return NULL;
    char *block = malloc(HEADER + size);
    if (!block)
        abort();
    memcpy(block, &size, sizeof size);
    all->in_use += size;
    return block + HEADER;
}

static void release(void *context, void *memory_of, size_t size)
{
    memory *all = context;
    char *block = (char *)memory_of - HEADER;
    if (memcmp(block, &size, sizeof size) != 0)
        abort();
    all->in_use -= size;
    free(block);
}

// Its use ---------------------------------------------------------------------

void allocator_begin(void)
{
    call made = call_begin("tf_set_allocator");
    own = (memory){.left = -1};
    judge_status(&made, tf_set_allocator(allocate, release, &own));
    require(&made, tf_memory_peak() == 0, "the peak is not zero");
}

void allocator_end(void)
{
    call made = call_begin("all calls");
    require(&made, tf_memory_in_use() == 0, "there is a leak");
    require(&made, own.in_use == 0, "memory is counted wrongly");
}

void allocator_fail(generator *random)
{
    own.failed = false;
    if (!one_in(random, 16))
        return;
    own.left = below(random, one_in(random, 2) ? 4 : 40);
    own.again = one_in(random, 2);
}

bool allocator_succeed(void)
{
    own.left = -1;
    return own.failed;
}

long allocator_calls(void)
{
    return own.allocations;
}

void call_allocator(generator *random)
{
    call made = call_begin("tf_set_allocator");
    bool none = one_in(random, 2);
    require(&made, tf_memory_in_use() == own.in_use, "memory is miscounted");
    require(&made, tf_memory_peak() >= own.in_use, "the peak is too low");
    expect_fault(&made, own.in_use > 0, TF_IN_USE);
    tf_status status = none ? tf_set_allocator(NULL, NULL, NULL)
                            : tf_set_allocator(allocate, release, NULL);
    if (judge_status(&made, status))
        allocator_begin();
}
