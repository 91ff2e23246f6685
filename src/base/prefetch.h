//: Prefetch memory
#pragma once

#include "base/always_inline.h"

/// Loads the cache line at an address that will be read soon.  It does not
/// wait, and cannot fail, whatever the address; no result depends on it.  A
/// function that only prefetches must be inlined into its callers, too: gcc
/// leaves out calls of a function that returns and stores nothing.
TF_ALWAYS_INLINE void tf_prefetch(const void *address)
{
#ifdef __GNUC__
    __builtin_prefetch(address);
#else
    (void)address;
#endif
}

//: Prefetch memory to the second cache
/// The same, but loads the line no nearer than the second cache.
TF_ALWAYS_INLINE void tf_prefetch_far(const void *address)
{
#ifdef __GNUC__
    __builtin_prefetch(address, 0, 2); // to be read; 3 would be the first cache
#else
    (void)address;
#endif
}
