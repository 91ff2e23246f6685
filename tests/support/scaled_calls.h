// Random calls that remesh, reconnect or move adaptive surfaces at all scales,
// with slivers and needles, and the judge of what they leave: it is embedded, it
// is what the call makes of the same surface at unit scale, and no report has a
// number that is none.
#ifndef SUPPORT_SCALED_CALLS_H
#define SUPPORT_SCALED_CALLS_H

#include "support/adaptive_scenes.h"

typedef enum scaled_call {
    REMESH,
    RECONNECT,
    FLOW,
    SCALED_CALLS
} scaled_call;

/// How often calls were answered, and refused as too large.
typedef struct scaled_counts {
    long done[SCALED_CALLS], refused[SCALED_CALLS];
} scaled_counts;

/// Makes a scene, multiplies each of its axes by a power of two, calls, and
/// judges.  Returns the first fault, or NULL.  Static storage.
const char *run_scaled_call(generator random, adaptive_scene_kind kind,
                            scaled_counts *counts);

/// Prints a table.
void scaled_counts_print(const scaled_counts *counts);

#endif
