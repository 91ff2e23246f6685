//: Set the allocator
#include "base/allocator.h"

#include "base/memory.h"
#include "base/require.h"

tf_status tf_set_allocator(tf_allocate_function *allocate,
                           tf_free_function *release, void *context)
{
    TF_REQUIRE(!allocate == !release);
    tf_memory *memory = &tf_library_memory;
    if (tf_memory_in_use() > 0)
        return TF_IN_USE;
    memory->allocate = allocate;
    memory->release = release;
    memory->context = context;
    atomic_store(&memory->peak, 0);
    return TF_OK;
}

//: Tell how much memory is in use
size_t tf_memory_in_use(void)
{
    return atomic_load(&tf_library_memory.in_use);
}

size_t tf_memory_peak(void)
{
    return atomic_load(&tf_library_memory.peak);
}
