//: List the vertices of two edges
#pragma once

#include "base/always_inline.h"
#include "surface/surface_memory.h"

#include <stddef.h>

/// Lists the vertices of two edges, which are sorted, and sorts the edges by
/// their first vertices, which differ.  No branch: nobody could guess which comes
/// first.
TF_ALWAYS_INLINE void tf_edge_pair_vertices(const int a[2], const int b[2],
                                            int vertex[4])
{
    int swap = -(b[0] < a[0]); // all bits or none
    for (int i = 0; i < 2; i++) {
        int change = (a[i] ^ b[i]) & swap;
        vertex[i] = a[i] ^ change;
        vertex[2 + i] = b[i] ^ change;
    }
}

//: List the vertices of a pair
/// Lists the vertices of two elements, of which the first has `corners` and the
/// second has `others`, no fewer: in the order of a tf_surface_contact.
TF_ALWAYS_INLINE void tf_pair_vertices(const tf_surface *surface, int corners,
                                       int others, tf_candidate pair,
                                       int vertex[])
{
    const int *first = corners == 1
                           ? &pair.first
                           : surface->edges.corner + 2 * (ptrdiff_t)pair.first;
    const int *second =
        (others == 2 ? surface->edges.corner : surface->triangles.corner) +
        (ptrdiff_t)others * pair.second;
    if (corners == 2 && others == 2) {
        tf_edge_pair_vertices(first, second, vertex);
        return;
    }
    for (int i = 0; i < corners; i++)
        vertex[i] = first[i];
    for (int i = 0; i < others; i++)
        vertex[corners + i] = second[i];
}
