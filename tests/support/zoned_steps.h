// Random steps from tangled starts, resolved outside of zones, and what may be
// wrong with them.
#ifndef SUPPORT_ZONED_STEPS_H
#define SUPPORT_ZONED_STEPS_H

#include <stdbool.h>

/// How often what happened.
typedef struct zoned_counts {
    long steps;    ///< from tangled starts
    long refused;  ///< starts that are tangled outside of zones, too
    long zones;    ///< of all starts
    long left_out; ///< intersections of starts within zones
    long pairs;   ///< of triangles, or edges in the plane, that share no vertex
                  ///< and are not both in one zone
    long met;     ///< steps with contacts outside of zones
    long rescued; ///< by the failsafe
    long exact;   ///< judged on the way, too
    long faulty;  ///< steps with a fault
} zoned_counts;

/// Resolves a few steps of a number, by seed, and judges the pairs of triangles
/// that are not both in one zone: they must not meet at the end, and in some of
/// the steps on small meshes not on the way.  Zones must not grow.  Returns
/// what is wrong first; NULL if nothing is.  Static storage.
/// @param weak whether to plant a weaker rule: pairs are left out if some
///     triangles at the two elements are in one zone, instead of all
const char *zoned_fault(long number, bool weak, zoned_counts *counts);

/// One line to standard output.
void zoned_counts_print(const zoned_counts *counts);

#endif
