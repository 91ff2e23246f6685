#include "kit/facets.h"

#include <stdlib.h>
#include <string.h>

static const int *corners(const fig_facets *facets, int facet)
{
    return facets->vertex + (ptrdiff_t)facets->axes * facet;
}

bool fig_facets_find(fig_facets *facets, const fig_shape *shape)
{
    bool flat = shape->axes == 2;
    *facets = (fig_facets){.axes = shape->axes,
                           .count = flat ? shape->edges : shape->triangles,
                           .vertex = flat ? shape->edge : shape->triangle};
    size_t places = (size_t)facets->axes * (size_t)facets->count;
    facets->first = calloc((size_t)shape->vertices + 2, sizeof(int));
    facets->at = malloc((places + 1) * sizeof(int));
    if (!facets->first || !facets->at)
        return false;
    // Counts are two places ahead, so that filling the list moves them to where
    // each vertex begins.
    int *next = facets->first + 1;
    for (size_t i = 0; i < places; i++)
        next[facets->vertex[i] + 1]++;
    for (int v = 0; v < shape->vertices; v++)
        next[v + 1] += next[v];
    for (size_t i = 0; i < places; i++)
        facets->at[next[facets->vertex[i]]++] = (int)(i / (size_t)facets->axes);
    return true;
}

void fig_facets_free(fig_facets *facets)
{
    free(facets->first);
    free(facets->at);
    *facets = (fig_facets){0};
}

static bool has(const fig_facets *facets, int facet, int vertex)
{
    const int *own = corners(facets, facet);
    return own[0] == vertex || own[1] == vertex ||
           (facets->axes == 3 && own[2] == vertex);
}

int fig_facets_next(const fig_facets *facets, int vertices, const int vertex[],
                    int *at)
{
    int first = facets->first[vertex[0]];
    while (first + *at < facets->first[vertex[0] + 1]) {
        int facet = facets->at[first + (*at)++];
        int i = 1;
        while (i < vertices && has(facets, facet, vertex[i]))
            i++;
        if (i == vertices)
            return facet;
    }
    return -1;
}
