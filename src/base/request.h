//: Request memory early
#pragma once

#include "base/inside.h"

/// Asks for the memory at a place that will be read soon.  It does not wait, and
/// cannot fail, whatever the place; no result depends on it.  A function that
/// only requests must be inside its callers, too: gcc leaves out calls of a
/// function that returns and stores nothing.
TF_INSIDE void tf_request(const void *place)
{
#ifdef __GNUC__
    __builtin_prefetch(place);
#else
    (void)place;
#endif
}

//: Request memory for the second cache
/// The same, but the memory goes only as near as the second cache.
TF_INSIDE void tf_request_far(const void *place)
{
#ifdef __GNUC__
    __builtin_prefetch(place, 0, 2); // to be read; 3 would be the first cache
#else
    (void)place;
#endif
}
