// The library's long calls, on surfaces of 100,000 triangles.
#ifndef BENCH_LONG_CALLS_H
#define BENCH_LONG_CALLS_H

#include "bench/latency.h"

/// Of surfaces and their steps, and of adaptive surfaces.  The last has no name.
extern const long_call surface_calls[], adaptive_calls[];

#endif
