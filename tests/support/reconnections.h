// Random merges, pinches and drops among other operations on adaptive surfaces,
// and the judge of what they leave: no intersections, and how the parts are
// nested and which way they are turned changes only as it must.
#ifndef SUPPORT_RECONNECTIONS_H
#define SUPPORT_RECONNECTIONS_H

#include "support/surgery_runs.h"
#include "topology/reconnect.h"

typedef struct reconnection_counts {
    long count[TF_RECONNECTIONS][TF_OUTCOMES];
    long joined, split; ///< merges of two parts, pinches that made two of one
    surgery_counts others;
} reconnection_counts;

/// Tries so many operations on a scene, of which about half reconnect it,
/// leaving out tests of the library (bits 1 << outcome); judges after each that
/// is done, and compares the surface after each that is not.  Returns the first
/// fault, or NULL.  Static storage.
const char *run_reconnections(generator random, adaptive_scene_kind kind,
                              int operations, unsigned left_out,
                              reconnection_counts *counts);

/// Prints a table.
void reconnection_counts_print(const reconnection_counts *counts);

#endif
