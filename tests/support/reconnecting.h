// Random merges, pinches and drops among other operations on adaptive surfaces,
// and the judge of what they leave: no intersections, and how the parts are
// nested and which way they are turned changes only as it must.
#ifndef SUPPORT_RECONNECTING_H
#define SUPPORT_RECONNECTING_H

#include "support/operating.h"
#include "topology/reconnect.h"

typedef struct reconnecting_counts {
    long count[TF_RECONNECTIONS][TF_OUTCOMES];
    long joined, split; ///< merges of two parts, pinches that made two of one
    operating_counts others;
} reconnecting_counts;

/// Tries so many operations on a scene, of which about half reconnect it,
/// leaving out tests of the library (bits 1 << outcome); judges after each that
/// is done, and compares the surface after each that is not.  Returns the first
/// fault, or NULL.  Static storage.
const char *reconnecting_run(generator random, adaptive_scene_kind kind,
                             int operations, unsigned left_out,
                             reconnecting_counts *counts);

/// Prints a table.
void reconnecting_counts_print(const reconnecting_counts *counts);

/// Gives each vertex of a surface the number of its part; returns how many
/// parts there are.  -1: it has no triangles.
int label_parts(const tf_adaptive_surface *surface, int part[]);

#endif
