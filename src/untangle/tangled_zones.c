//: Include what the zones of a surface need
#include "untangle/tangled_zones.h"

#include "base/fail.h"
#include "base/require.h"
#include "response/groups.h"
#include "untangle/neighbors.h"

#include <stddef.h>
#include <string.h>

//: Hold the zones that are being found
typedef struct zone_search {
    tf_neighbors near;
    tf_crossings found;
    tf_groups groups; ///< of facets
    tf_buffer marks;
    int *ring;  ///< of each vertex: the first ring of which a facet has it, the
                ///< crossing facets being the first of all; 0: none
    int *in;    ///< of each facet: whether it is in a zone
    int *queue; ///< vertices of these, in the order of their rings
    int queued;
} zone_search;

//: Find the facets at an element
typedef struct facet_list {
    int count, only;
    const int *facet; ///< NULL: `only`
} facet_list;

static facet_list facets_of(const tf_neighbors *near, int corners,
                            const int v[])
{
    if (corners == 3)
        return (facet_list){1, tf_triangle_of(near, v[0], v[1], v[2]), NULL};
    int place = corners == 1 ? v[0] : tf_edge_of(near, v[0], v[1]);
    if (corners == near->axes)
        return (facet_list){1, place, NULL};
    const tf_lists *lists = corners == 1 ? &near->facets_at : &near->sides;
    return (facet_list){tf_list_length(lists, place), -1,
                        lists->item + lists->start[place]};
}

static int facet_in(const facet_list *list, int i)
{
    return list->facet ? list->facet[i] : list->only;
}

//: Put what crosses into zones
static void put_in(zone_search *search, const facet_list *list, int with)
{
    for (int i = 0; i < list->count; i++) {
        int own = facet_in(list, i);
        search->in[own] = 1;
        tf_groups_unite(&search->groups, own, with);
    }
}

static void put_crossings_in(zone_search *search)
{
    for (size_t i = 0; i < search->found.count; i++) {
        const tf_crossing *own = &search->found.crossing[i];
        int first = own->kind == TF_POINT_ON_TRIANGLE ? 1 : 2;
        int second = own->kind == TF_EDGE_ON_EDGE ? 2 : 3;
        facet_list a = facets_of(&search->near, first, own->vertex);
        facet_list b = facets_of(&search->near, second, own->vertex + first);
        if (a.count == 0 || b.count == 0)
            continue;
        put_in(search, &a, facet_in(&a, 0));
        put_in(search, &b, facet_in(&a, 0));
    }
}

//: Add rings to zones
/// Puts the vertices of a facet behind those that are in the queue, unless they
/// are.
static void queue_corners(zone_search *search, int facet, int ring)
{
    int corners = search->near.axes;
    const int *v = search->near.facet + (ptrdiff_t)corners * facet;
    for (int i = 0; i < corners; i++) {
        if (search->ring[v[i]] > 0)
            continue;
        search->ring[v[i]] = ring;
        search->queue[search->queued++] = v[i];
    }
}

static void add_rings(zone_search *search, int rings)
{
    const tf_lists *at = &search->near.facets_at;
    for (int f = 0; f < search->near.facets; f++)
        if (search->in[f])
            queue_corners(search, f, 1);
    for (int i = 0; i < search->queued; i++) {
        int v = search->queue[i], ring = search->ring[v];
        if (ring > rings)
            return;
        for (int j = at->start[v]; j < at->start[v + 1]; j++) {
            int own = at->item[j];
            if (search->in[own])
                continue;
            search->in[own] = 1;
            queue_corners(search, own, ring + 1);
        }
    }
}

//: Unite what shares a vertex
static void unite_neighbors(zone_search *search)
{
    const tf_lists *at = &search->near.facets_at;
    for (int v = 0; v < search->near.vertices; v++) {
        int first = -1;
        for (int i = at->start[v]; i < at->start[v + 1]; i++) {
            int own = at->item[i];
            if (!search->in[own])
                continue;
            first = first < 0 ? own : first;
            tf_groups_unite(&search->groups, first, own);
        }
    }
}

//: Number zones
/// The root of a group is its first facet, which therefore has its number
/// before the others need it.
static int number_zones(zone_search *search, int zone[])
{
    int zones = 0;
    for (int f = 0; f < search->near.facets; f++) {
        int root = tf_groups_find(&search->groups, f);
        zone[f] = !search->in[f] ? -1 : root == f ? zones++ : zone[root];
    }
    return zones;
}

//: Find the zones of a surface
static bool reserve(zone_search *search, const tf_surface *surface)
{
    tf_neighbors *near = &search->near;
    if (!tf_neighbors_find(near, surface))
        return false;
    size_t vertices = (size_t)near->vertices, facets = (size_t)near->facets;
    if (!tf_groups_begin(&search->groups, near->facets) ||
        !tf_buffer_reserve(&search->marks, 2 * vertices + facets, sizeof(int)))
        return false;
    search->ring = search->marks.data;
    search->in = search->ring + vertices;
    search->queue = search->in + facets;
    memset(search->ring, 0, (vertices + facets) * sizeof(int));
    return true;
}

static void end(zone_search *search)
{
    tf_neighbors_free(&search->near);
    tf_buffer_free(&search->groups.storage);
    tf_buffer_free(&search->marks);
}

tf_status tf_surface_zones(tf_surface *surface, int vertices,
                           const double position[], int rings,
                           const tf_check_options *options, int zone[],
                           int *zones, tf_crossings *found, tf_error *error)
{
    TF_REQUIRE(surface && position && zone);
    zone_search search = {.ring = NULL};
    if (rings < 0)
        return tf_fail_option(error, "rings", "0 or more", rings);
    tf_status status = tf_surface_check(surface, vertices, position, options,
                                        &search.found, error);
    if (status == TF_OK && !reserve(&search, surface))
        status = tf_fail(error, TF_OUT_OF_MEMORY);
    if (status == TF_OK) {
        put_crossings_in(&search);
        add_rings(&search, rings);
        unite_neighbors(&search);
        int count = number_zones(&search, zone);
        if (zones)
            *zones = count;
        if (found)
            *found = search.found;
    }
    end(&search);
    return status;
}
