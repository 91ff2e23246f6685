//: Include what scopes need
#include "untangle/scope.h"

#include <string.h>

//: Mark what crosses
/// Marks the vertices of crossings and of wrong regions by 1; returns how many.
static int mark_crossings(const tf_tangle *tangle, const tf_regions *regions,
                          int mark[], int *queue)
{
    const tf_neighbors *all = &tangle->near;
    int count = 0;
    memset(mark, 0, sizeof *mark * (size_t)all->vertices);
    for (size_t i = 0; i < tangle->crossings.count; i++) {
        const tf_crossing *own = &tangle->crossings.crossing[i];
        for (int j = 0; j < tf_crossing_corners(own); j++)
            mark[own->vertex[j]] = 1;
    }
    for (int v = 0; v < all->vertices; v++) {
        if (regions && tf_is_wrong(regions, all, regions->region[v]))
            mark[v] = 1;
        if (mark[v])
            queue[count++] = v;
    }
    return count;
}

//: Mark rings of neighbors
static void mark_neighbors(const tf_neighbors *all, int mark[], int rings,
                           int *queue, int count)
{
    for (int i = 0; i < count; i++) {
        int v = queue[i];
        if (mark[v] > rings)
            return;
        for (int j = all->around.start[v]; j < all->around.start[v + 1]; j++) {
            int other = all->around.item[j];
            if (mark[other])
                continue;
            mark[other] = mark[v] + 1;
            queue[count++] = other;
        }
    }
}

int *tf_mark_rings(tf_buffer *marks, const tf_tangle *tangle,
                   const tf_regions *regions, int rings)
{
    const tf_neighbors *all = &tangle->near;
    if (!tf_buffer_reserve(marks, 2 * (size_t)all->vertices, sizeof(int)))
        return NULL;
    int *mark = marks->data, *queue = mark + all->vertices;
    int count = mark_crossings(tangle, regions, mark, queue);
    mark_neighbors(all, mark, rings, queue, count);
    return mark;
}

//: Unite zones
static int root_of(int *zone, int vertex)
{
    while (zone[vertex] != vertex)
        vertex = zone[vertex] = zone[zone[vertex]];
    return vertex;
}

static void unite(int *zone, int corners, const int corner[])
{
    for (int i = 1; i < corners; i++) {
        int a = root_of(zone, corner[0]), b = root_of(zone, corner[i]);
        zone[a > b ? a : b] = a > b ? b : a;
    }
}

/// What is not in a zone with all its neighbors is not within it.
static void leave(tf_scope *scope, const tf_neighbors *all, int corners,
                  const int corner[])
{
    for (int i = 0; i < corners; i++)
        scope->within[corner[i]] = 0;
    if (corners == 3)
        for (int i = 0; i < 3; i++) {
            int edge = tf_edge_of(all, corner[i], corner[(i + 1) % 3]);
            scope->within[all->vertices + edge] = 0;
        }
}

//: Take elements into zones
/// Elements with a marked vertex are in a zone.  `within` is of these elements.
static void take_elements(tf_scope *scope, const tf_neighbors *all,
                          const int mark[], int corners, int count,
                          const int *corner, unsigned char *within)
{
    for (int i = 0; i < count; i++) {
        const int *own = corner + (ptrdiff_t)corners * i;
        bool in = false;
        for (int j = 0; j < corners; j++)
            in = in || mark[own[j]];
        if (in)
            unite(scope->zone, corners, own);
        else
            leave(scope, all, corners, own);
        if (!in)
            within[i] = 0;
    }
}

//: Find the zones of a round
static bool reserve(tf_scope *scope, const tf_neighbors *all)
{
    size_t v = (size_t)all->vertices;
    size_t elements = v + (size_t)all->edges + (size_t)all->triangles;
    if (!tf_buffer_reserve(&scope->storage, v * sizeof(int) + elements, 1))
        return false;
    scope->zone = scope->storage.data;
    scope->within = (unsigned char *)(scope->zone + v);
    memset(scope->within, 1, elements);
    for (int i = 0; i < all->vertices; i++)
        scope->zone[i] = i;
    return true;
}

bool tf_scope_find(tf_scope *scope, const tf_tangle *tangle,
                   const tf_regions *regions, int rings)
{
    const tf_neighbors *all = &tangle->near;
    const int *mark = tf_mark_rings(&scope->marks, tangle, regions, rings);
    if (!mark || !reserve(scope, all))
        return false;
    unsigned char *edges = scope->within + all->vertices;
    take_elements(scope, all, mark, 3, all->triangles, all->triangle,
                  edges + all->edges);
    take_elements(scope, all, mark, 2, all->edges, all->edge, edges);
    for (size_t i = 0; i < tangle->crossings.count; i++) {
        const tf_crossing *own = &tangle->crossings.crossing[i];
        unite(scope->zone, tf_crossing_corners(own), own->vertex);
    }
    for (int v = 0; v < all->vertices; v++)
        scope->zone[v] = root_of(scope->zone, v);
    return true;
}

void tf_scope_free(tf_scope *scope)
{
    tf_buffer_free(&scope->storage);
    tf_buffer_free(&scope->marks);
}

//: Tell whether a contact is in a zone
/// The place of an element among all elements.
static int element_of(const tf_neighbors *all, int corners, const int corner[])
{
    if (corners == 1)
        return corner[0];
    if (corners == 2)
        return all->vertices + tf_edge_of(all, corner[0], corner[1]);
    return all->vertices + all->edges +
           tf_triangle_of(all, corner[0], corner[1], corner[2]);
}

/// The zone that an element of a contact is within, or -1.
static int zone_of(const tf_scope *scope, const tf_neighbors *all, int corners,
                   const int corner[])
{
    bool within = scope->within[element_of(all, corners, corner)];
    return within ? scope->zone[corner[0]] : -1;
}

bool tf_scope_has(const tf_scope *scope, const tf_neighbors *all,
                  const tf_surface_contact *contact)
{
    const int *v = contact->vertex;
    int first = contact->kind == TF_EDGE_EDGE ? 2 : 1;
    int second = contact->kind == TF_POINT_TRIANGLE ? 3 : 2;
    int own = zone_of(scope, all, first, v);
    return own >= 0 && own == zone_of(scope, all, second, v + first);
}
