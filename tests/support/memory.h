// Memory for tests and measurements, which end without it.
#ifndef SUPPORT_MEMORY_H
#define SUPPORT_MEMORY_H

#include <stddef.h>

/// Zeros; to be freed, also where `count` is 0.
void *allocate(size_t count, size_t size);

/// Whole cache lines of 64 bytes, not set.
void *allocate_lines(size_t count, size_t size);

#endif
