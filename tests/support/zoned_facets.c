#include "support/zoned_facets.h"

zoned_facets zoned_facets_of(const tf_surface *surface, const int zone[])
{
    zoned_facets all = {.axes = tf_surface_axes(surface), .zone = zone};
    all.edge = tf_surface_edges(surface, &all.edges);
    all.facet = all.edge;
    all.facets = all.edges;
    if (all.axes == 3)
        all.facet = tf_surface_triangles(surface, &all.facets);
    return all;
}

void zones_draw(generator *random, const tf_surface *surface, int zone[])
{
    zoned_facets all = zoned_facets_of(surface, zone);
    int zones = 1 + below(random, 3), length = 1 + below(random, 2 * 16);
    for (int f = 0, own = 0; f < all.facets; f++) {
        if (f % length == 0)
            own = below(random, zones + 1) - 1;
        zone[f] = own;
    }
}

static bool has_vertex(int corners, const int v[], int vertex)
{
    for (int i = 0; i < corners; i++)
        if (v[i] == vertex)
            return true;
    return false;
}

bool facet_has(const zoned_facets *all, int facet, int corners, const int v[])
{
    for (int i = 0; i < corners; i++)
        if (!has_vertex(all->axes, all->facet + all->axes * facet, v[i]))
            return false;
    return true;
}

static int count_facets(const zoned_facets *all, int corners, const int v[])
{
    int count = 0;
    for (int f = 0; f < all->facets; f++)
        count += facet_has(all, f, corners, v);
    return count;
}

static bool ends_bare_edge(const zoned_facets *all, int vertex)
{
    for (int e = 0; e < all->edges; e++)
        if (has_vertex(2, all->edge + 2 * e, vertex) &&
            count_facets(all, 2, all->edge + 2 * e) == 0)
            return true;
    return false;
}

bool is_bare(const zoned_facets *all, int corners, const int v[])
{
    return count_facets(all, corners, v) == 0 ||
           (corners == 1 && ends_bare_edge(all, v[0]));
}

int zone_of_element(const zoned_facets *all, int corners, const int v[])
{
    int zone = -1;
    bool first = true;
    for (int f = 0; f < all->facets; f++) {
        if (!facet_has(all, f, corners, v))
            continue;
        if (all->zone[f] < 0 || (!first && all->zone[f] != zone))
            return -1;
        zone = all->zone[f];
        first = false;
    }
    return is_bare(all, corners, v) ? -1 : zone;
}

bool zones_leave_out(const zoned_facets *all, int corners, const int v[],
                     int others, const int w[])
{
    int zone = zone_of_element(all, corners, v);
    return zone >= 0 && zone == zone_of_element(all, others, w);
}

static bool are_in_one_zone(const zoned_facets *all, int f, int g)
{
    return all->zone[f] >= 0 && all->zone[f] == all->zone[g];
}

bool some_zones_meet(const zoned_facets *all, int corners, const int v[],
                     int others, const int w[])
{
    for (int f = 0; f < all->facets; f++)
        for (int g = 0; facet_has(all, f, corners, v) && g < all->facets; g++)
            if (facet_has(all, g, others, w) && are_in_one_zone(all, f, g))
                return true;
    return false;
}

static bool share_vertex(const zoned_facets *all, int f, int g)
{
    const int *v = all->facet + all->axes * f;
    for (int i = 0; i < all->axes; i++)
        if (has_vertex(all->axes, all->facet + all->axes * g, v[i]))
            return true;
    return false;
}

long count_pairs_kept_apart(const zoned_facets *all)
{
    long count = 0;
    for (int f = 0; f < all->facets; f++)
        for (int g = f + 1; g < all->facets; g++)
            count += !are_in_one_zone(all, f, g) && !share_vertex(all, f, g);
    return count;
}

bool is_outside_of_zones(const zoned_facets *all, const tangle *found)
{
    static const int corners[][2] = {[EDGE_PIERCES_TRIANGLE] = {2, 3},
                                     [POINT_IN_TRIANGLE] = {1, 3},
                                     [EDGES_MEET] = {2, 2},
                                     [POINT_IN_EDGE] = {1, 2}};
    int first = corners[found->kind][0], second = corners[found->kind][1];
    const int *v = found->vertex, *w = v + first;
    if (count_facets(all, first, v) == 0 || count_facets(all, second, w) == 0)
        return true;
    for (int f = 0; f < all->facets; f++)
        for (int g = 0; facet_has(all, f, first, v) && g < all->facets; g++)
            if (facet_has(all, g, second, w) && !are_in_one_zone(all, f, g))
                return true;
    return false;
}
