// The intersections of a surface at rest, by linear programs in rational
// numbers, of every pair of its elements.
#ifndef SUPPORT_CROSSINGS_H
#define SUPPORT_CROSSINGS_H

#include "surface/check.h"

enum {
    MOST_CROSSINGS = 100000
};

/// What all pairs of elements that share no vertex answer, in the order of a
/// check's rows.
typedef struct oracle_crossings {
    int axes;
    const double *position;
    int count;
    tf_crossing row[MOST_CROSSINGS];
} oracle_crossings;

/// Tries all pairs of a surface with this many vertices.
void oracle_crossings_find(oracle_crossings *all, const tf_surface *surface,
                           int axes, int vertices, const double position[]);

#endif
