// Functions without memory: each of their allocations fails in turn.
#ifndef SUPPORT_FAILING_MEMORY_H
#define SUPPORT_FAILING_MEMORY_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/// Makes objects, calls functions until each has enough memory, and frees the
/// objects; returns a hash of what it got.
typedef uint64_t act_function(void);

/// Lets each allocation of an act fail in turn, the first, the second and so
/// on.  The hash must always be the same, and all memory must be freed.
void let_each_fail(act_function *act);

/// Of an act: whether a call, which returned a status, had too little memory and
/// is to be repeated.  From then on there is enough.
bool lacks_memory(tf_status status);

/// Of an act: expects that objects which say how much memory they hold say all,
/// but for its alignment.
void expect_told(size_t bytes);

#endif
