//: Include what the join of elements needs
#include "surface/filtered_join.h"

#include "surface/pair_vertices.h"

#include <stddef.h>
#include <string.h>

//: Find the group of an element
/// The group that all these vertices have; 0: they have none in common.
static int group_of(const tf_pair_filter *filter, int corners,
                    const int vertex[])
{
    if (!filter->group)
        return 0;
    int group = filter->group[vertex[0]];
    for (int i = 1; i < corners; i++)
        if (filter->group[vertex[i]] != group)
            return 0;
    return group;
}

//: Ask the filter about a pair
/// About a pair of elements that a step has, in any order.
static bool is_wanted(const tf_pair_filter *filter, int corners,
                      const int first[], int others, const int second[])
{
    if (others < corners || (others == corners && second[0] < first[0]))
        return is_wanted(filter, others, second, corners, first);
    int group = group_of(filter, corners, first);
    int other = group_of(filter, others, second);
    if (group != 0 && group == other)
        return false;
    if (!filter->wanted)
        return true;
    tf_element_pair pair = {.kind = others == 3    ? TF_POINT_TRIANGLE
                                    : corners == 2 ? TF_EDGE_EDGE
                                                   : TF_POINT_EDGE,
                            .vertex = {-1, -1, -1, -1},
                            .group = {group, other}};
    memcpy(pair.vertex, first, sizeof *first * (size_t)corners);
    memcpy(pair.vertex + corners, second, sizeof *second * (size_t)others);
    return filter->wanted(filter->context, &pair);
}

//: Leave out what is scripted
/// Whether two elements can meet by the filter, and one of their vertices can be
/// moved, so that something can be done about it.
static bool is_kept(const tf_surface *surface, int corners, const int first[],
                    int others, const int second[])
{
    const tf_pair_filter *filter = &surface->filter;
    const double *inverse_mass = surface->inverse_mass;
    bool moves = !inverse_mass;
    for (int i = 0; i < corners && !moves; i++)
        moves = inverse_mass[first[i]] > 0;
    for (int i = 0; i < others && !moves; i++)
        moves = inverse_mass[second[i]] > 0;
    return moves && ((!filter->group && !filter->wanted) ||
                     is_wanted(filter, corners, first, others, second));
}

//: Ask the filter about a pair at rest
/// Whether all pairs are kept that remain without one of the vertices.
static bool is_kept_at_rest(const tf_surface *surface, int corners, int others,
                            const int vertex[])
{
    for (int i = 0; i < corners + others; i++) {
        int rest[4], count = 0, first = corners - (i < corners);
        for (int j = 0; j < corners + others; j++)
            if (j != i)
                rest[count++] = vertex[j];
        if (!is_kept(surface, first, rest, count - first, rest + first))
            return false;
    }
    return true;
}

//: Note the zone of a facet at an element
enum {
    NO_ZONE = -1,
    NO_FACETS = -2 ///< no facet of the element has been looked at
};

/// Notes that a facet at an element is in a zone, or below 0 in none.
static void note_zone(int *own, int zone)
{
    if (zone < 0 || (*own != NO_FACETS && *own != zone))
        zone = NO_ZONE;
    *own = zone;
}

//: Find an edge in a sorted list
/// The place of an edge in a sorted list that has it.
static int find_edge(const tf_elements *edges, int a, int b)
{
    int low = 0, high = edges->count - 1;
    while (low < high) {
        int middle = low + (high - low) / 2;
        const int *own = edges->corner + 2 * (ptrdiff_t)middle;
        if (own[0] < a || (own[0] == a && own[1] < b))
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

//: Find the zones of elements
static void note_triangles(const tf_surface *surface, const int zone[],
                           int vertex[], int edge[])
{
    const int *corner = surface->triangles.corner;
    for (int i = 0; i < surface->triangles.count; i++, corner += 3)
        for (int j = 0; j < 3; j++) {
            int from = corner[j == 2], to = corner[j == 0 ? 1 : 2];
            note_zone(&vertex[corner[j]], zone[i]);
            note_zone(&edge[find_edge(&surface->edges, from, to)], zone[i]);
        }
}

/// An edge of no triangle is in no zone, and then nor are its ends.  In the
/// plane, edges have zones of their own.
static void note_edges(const tf_surface *surface, const int zone[],
                       int vertex[], int edge[])
{
    const int *corner = surface->edges.corner;
    for (int i = 0; i < surface->edges.count; i++, corner += 2) {
        if (surface->axes == 2)
            note_zone(&edge[i], zone[i]);
        for (int j = 0; j < 2; j++)
            if (surface->axes == 2 || edge[i] == NO_FACETS)
                note_zone(&vertex[corner[j]], edge[i]);
    }
}

//: Enter and leave zones
bool tf_surface_enter_zones(tf_surface *surface, const int zone[])
{
    size_t vertices = (size_t)surface->vertices,
           all = vertices + (size_t)surface->edges.count;
    if (!zone)
        return true;
    if (!tf_buffer_reserve(&surface->zones, all, sizeof(int)))
        return false;
    int *vertex = surface->zones.data, *edge = vertex + vertices;
    for (size_t i = 0; i < all; i++)
        vertex[i] = NO_FACETS;
    note_triangles(surface, zone, vertex, edge);
    note_edges(surface, zone, vertex, edge);
    surface->zone[0] = vertex;
    surface->zone[1] = edge;
    surface->zone[2] = zone;
    return true;
}

void tf_surface_leave_zones(tf_surface *surface)
{
    surface->zone[0] = surface->zone[1] = surface->zone[2] = NULL;
}

//: Filter a batch of pairs
enum {
    FILTER_WORK = 16 ///< units of work that the filter of a pair takes
};

typedef struct filter_job {
    const tf_surface *surface;
    int corners, others; ///< of the elements of each pair
    bool simple;         ///< whether a free vertex is all that a pair needs
    const int *zone, *other_zone; ///< of each element, or NULL
} filter_job;

/// Whether both elements of a pair are in one zone.
static bool is_in_zone(const filter_job *job, tf_candidate pair)
{
    return job->zone && job->zone[pair.first] >= 0 &&
           job->zone[pair.first] == job->other_zone[pair.second];
}

/// Whether a pair passes because the first of its vertices can be moved, and no
/// more is asked: most pairs do.
static bool passes_at_once(const filter_job *job, tf_candidate pair)
{
    const tf_surface *surface = job->surface;
    int first = job->corners == 1
                    ? pair.first
                    : surface->edges.corner[2 * (ptrdiff_t)pair.first];
    return job->simple && surface->inverse_mass[first] > 0;
}

static bool passes(const filter_job *job, tf_candidate pair)
{
    const tf_surface *surface = job->surface;
    int corners = job->corners, others = job->others, vertex[5];
    if (is_in_zone(job, pair))
        return false;
    tf_pair_vertices(surface, corners, others, pair, vertex);
    return corners + others > surface->axes + 1
               ? is_kept_at_rest(surface, corners, others, vertex)
               : is_kept(surface, corners, vertex, others, vertex + corners);
}

/// Drops pairs from a sink: its function of that name.
static void filter_pairs(tf_pair_sink *sink)
{
    const filter_job *job = sink->filter_job;
    tf_worker *worker = (tf_worker *)sink;
    tf_watch *watch = job->surface->workers.watch;
    int kept = 0;
    for (int i = 0; i < sink->count; i++) {
        tf_candidate pair = sink->pair[i];
        sink->pair[kept] = pair;
        if (passes_at_once(job, pair)) {
            kept++;
            continue;
        }
        if (!tf_worker_works(worker, watch, FILTER_WORK))
            break;
        kept += passes(job, pair);
    }
    sink->count = kept;
    if (!tf_worker_goes_on(worker, watch, 0))
        sink->stopped = true;
}

//: Join elements
static const tf_tree *tree_of(const tf_surface *surface, int corners)
{
    return corners == 1   ? &surface->vertex_tree
           : corners == 2 ? &surface->edge_tree
                          : &surface->triangle_tree;
}

void tf_surface_join(tf_surface *surface, int corners, int others,
                     bool (*take)(tf_pair_sink *, int, const tf_candidate[]),
                     tf_task_rows rows[], const tf_parallel *parallel)
{
    tf_workers *workers = &surface->workers;
    bool asks = surface->filter.group || surface->filter.wanted;
    bool zoned = surface->zone[0];
    bool filters = asks || zoned || surface->inverse_mass;
    filter_job job = {.surface = surface,
                      .corners = corners,
                      .others = others,
                      .simple = !asks && !zoned && surface->inverse_mass &&
                                corners + others <= surface->axes + 1,
                      .zone = surface->zone[corners - 1],
                      .other_zone = surface->zone[others - 1]};
    for (int i = 0; i < workers->count && filters; i++) {
        tf_pair_sink *sink = &workers->worker[i]->sink;
        sink->filter = filter_pairs;
        sink->filter_job = &job;
    }
    tf_workers_join(workers, tree_of(surface, corners),
                    tree_of(surface, others), take, rows, parallel);
    for (int i = 0; i < workers->count; i++)
        workers->worker[i]->sink.filter = NULL;
}
