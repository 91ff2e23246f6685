// The facets of a surface by their vertices: triangles, and in the plane edges.
#ifndef FIG_FACETS_H
#define FIG_FACETS_H

#include "kit/surface_shape.h"

typedef struct fig_facets {
    int axes;          ///< of the surface, and how many vertices a facet has
    int count;         ///< of facets
    const int *vertex; ///< of each facet; borrowed
    int *first;        ///< of each vertex: the first of its facets in the list
    int *at;           ///< the facets at all vertices, one vertex after another
} fig_facets;

/// List the facets of a shape, which is borrowed.  False if there is no memory;
/// they are to be freed in any case.
bool fig_facets_find(fig_facets *facets, const fig_shape *shape);
void fig_facets_free(fig_facets *facets);

/// Step to the next facet that has all these vertices: *at is 0 before the
/// first one.  -1 after the last one.
int fig_facets_next(const fig_facets *facets, int vertices, const int vertex[],
                    int *at);

#endif
