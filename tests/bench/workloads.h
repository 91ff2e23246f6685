// Queries to time, the same in every run.
#ifndef BENCH_WORKLOADS_H
#define BENCH_WORKLOADS_H

#include "geometry/event.h"

#include <stdbool.h>

enum {
    QUERY_VERTICES = 4
};

/// The vertices of the first element, then those of the second, by index.
typedef struct query {
    tf_worldline vertex[QUERY_VERTICES];
} query;

typedef struct workload {
    const char *name;
    bool rounded; ///< to the grid of the integers
    int vertices; ///< of the first element: 1 point-triangle, 2 edge-edge
    long count;
    query *queries;
} workload;

/// "point-triangle" or "edge-edge".
const char *workload_kind(const workload *w);

/// soup: vertices anywhere in the unit cube, displaced by up to 0.1 an axis.
workload workload_soup(int vertices);

/// near: the same, but all of a query starts in a cube of side 0.1.
workload workload_near(int vertices);

/// rest: a tilted flat cloth that does not move; all its pairs whose boxes
/// overlap.
workload workload_rest(int vertices);

/// lattice: coordinates 0, 1, 2 or 3, degenerate most of the time.
workload workload_lattice(int vertices);

/// The same queries with their coordinates, which are below 2 in absolute value,
/// rounded to integers below 2^19, the range of 64 bits.
workload workload_rounded(const workload *w);

void workload_free(workload *w);

#endif
