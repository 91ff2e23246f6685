#include "draw/surface_tangle.h"

#include "response/groups.h"

#include <stdlib.h>
#include <string.h>

// Zones ------------------------------------------------------------------

/// Zones on their way: those of the vertices that their facets have.
typedef struct search {
    const fig_facets *facets;
    tf_groups groups; ///< of vertices
    bool *reached;    ///< of each vertex: a facet that crosses has it
} search;

static const int *corners_of(const search *s, int facet)
{
    return s->facets->vertex + (ptrdiff_t)s->facets->axes * facet;
}

/// Put the facets at an element into the zone of a vertex.
static void reach(search *s, int vertices, const int vertex[], int zone)
{
    int step = 0, facet;
    while ((facet = fig_facets_next(s->facets, vertices, vertex, &step)) >= 0)
        for (int i = 0; i < s->facets->axes; i++) {
            int corner = corners_of(s, facet)[i];
            s->reached[corner] = true;
            tf_groups_unite(&s->groups, zone, corner);
        }
}

/// Put the facets beside those that cross into their zones.
static bool is_beside(search *s, int facet)
{
    bool beside = false;
    for (int i = 0; i < s->facets->axes; i++)
        beside = beside || s->reached[corners_of(s, facet)[i]];
    return beside;
}

static void add_neighbors(search *s, int zone[])
{
    for (int f = 0; f < s->facets->count; f++) {
        const int *own = corners_of(s, f);
        zone[f] = is_beside(s, f) ? 0 : -1;
        for (int i = 1; i < s->facets->axes && zone[f] == 0; i++)
            tf_groups_unite(&s->groups, own[0], own[i]);
    }
}

/// Number the zones by their first facets; returns how many there are.
static int number_zones(search *s, int zone[], int number[])
{
    int zones = 0;
    for (int f = 0; f < s->facets->count; f++) {
        int root = tf_groups_find(&s->groups, *corners_of(s, f));
        if (zone[f] < 0)
            continue;
        if (number[root] == 0)
            number[root] = ++zones;
        zone[f] = number[root] - 1;
    }
    return zones;
}

static void find_zones(fig_tangled *tangled, search *s,
                       const tf_crossings *found, int number[])
{
    for (size_t i = 0; i < found->count; i++) {
        const tf_crossing *own = &found->crossing[i];
        int first = own->kind == TF_POINT_ON_TRIANGLE ? 1 : 2;
        int second = own->kind == TF_EDGE_ON_EDGE ? 2 : 3;
        reach(s, first, own->vertex, own->vertex[0]);
        reach(s, second, own->vertex + first, own->vertex[0]);
    }
    add_neighbors(s, tangled->zone);
    tangled->zones = number_zones(s, tangled->zone, number);
}

// Both -------------------------------------------------------------------

static bool find_all_zones(fig_tangled *tangled, const fig_shape *shape,
                           const tf_crossings *found)
{
    fig_facets facets;
    size_t vertices = (size_t)shape->vertices;
    search s = {.facets = &facets, .reached = calloc(vertices + 1, 1)};
    int *number = calloc(vertices + 1, sizeof *number);
    bool good = fig_facets_find(&facets, shape) && s.reached && number &&
                tf_groups_begin(&s.groups, shape->vertices);
    if (good)
        tangled->zone = malloc(((size_t)facets.count + 1) * sizeof(int));
    good = good && tangled->zone;
    if (good)
        find_zones(tangled, &s, found, number);
    tf_buffer_free(&s.groups.storage);
    fig_facets_free(&facets);
    free(s.reached);
    free(number);
    return good;
}

static bool find_touching(fig_tangled *tangled, const tf_crossings *found)
{
    tangled->touches = malloc(found->count + 1);
    for (size_t i = 0; i < found->count && tangled->touches; i++)
        tangled->touches[i] =
            found->crossing[i].kind != TF_EDGE_THROUGH_TRIANGLE;
    return tangled->touches;
}

bool fig_tangled_find(fig_tangled *tangled, const fig_shape *shape,
                      const tf_crossings *found)
{
    *tangled = (fig_tangled){0};
    return find_all_zones(tangled, shape, found) &&
           find_touching(tangled, found) &&
           (shape->axes == 2 || fig_curve_pieces_find(&tangled->curves, shape,
                                                      shape->at[0], found));
}

void fig_tangled_free(fig_tangled *tangled)
{
    fig_curve_pieces_free(&tangled->curves);
    free(tangled->touches);
    free(tangled->zone);
    *tangled = (fig_tangled){0};
}
