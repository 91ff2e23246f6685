// The allocator of the calls, which can fail.
#ifndef FUZZ_CALLS_ALLOCATOR_H
#define FUZZ_CALLS_ALLOCATOR_H

#include "judge.h"

/// Has the library use the allocator; it must hold no memory.
void allocator_begin(void);

/// Requires that it holds no memory any more.
void allocator_end(void);

/// From now on lets an allocation fail, and perhaps all later ones, or none.
void allocator_fail(generator *random);

/// From now on lets none fail; returns whether one has failed.
bool allocator_succeed(void);

/// How many allocations there have been.
long allocator_calls(void);

/// Tries to replace the allocator while objects may hold memory.
void call_allocator(generator *random);

#endif
