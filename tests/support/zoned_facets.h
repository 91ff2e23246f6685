// Zones of triangles, in the plane of edges: what they leave out, by looking at
// all facets.
#ifndef SUPPORT_ZONED_FACETS_H
#define SUPPORT_ZONED_FACETS_H

#include "support/generator.h"
#include "support/tangle.h"
#include "surface/surface.h"

#include <stdbool.h>

/// The facets of a surface, whose lists are lent by it, with their zones.
typedef struct zoned_facets {
    int axes, facets, edges;
    const int *facet; ///< `axes` vertices each
    const int *edge;  ///< two vertices each
    const int *zone;  ///< of each facet; below 0: none
} zoned_facets;

zoned_facets zoned_facets_of(const tf_surface *surface, const int zone[]);

/// Fills `zone` with few numbers, each of facets that are near each other in
/// the list; some facets are in none.
void zones_draw(generator *random, const tf_surface *surface, int zone[]);

/// Whether a facet has all vertices of an element.
bool facet_has(const zoned_facets *all, int facet, int corners, const int v[]);

/// Whether an element has no facet, or is an end of an edge that has none.
bool is_bare(const zoned_facets *all, int corners, const int v[]);

/// The zone of an element: of all its facets; -1: none, also if it is bare.
int zone_of_element(const zoned_facets *all, int corners, const int v[]);

/// Whether two elements are left out: both are in one zone.
bool zones_leave_out(const zoned_facets *all, int corners, const int v[],
                     int others, const int w[]);

/// The weaker rule: whether some facets at the two elements are in one zone.
bool some_zones_meet(const zoned_facets *all, int corners, const int v[],
                     int others, const int w[]);

/// How many pairs of facets without a common vertex are not both in one zone.
long count_pairs_kept_apart(const zoned_facets *all);

/// Whether a tangle is of facets that are not both in one zone, or of an
/// element without facets.
bool is_outside_of_zones(const zoned_facets *all, const tangle *found);

#endif
