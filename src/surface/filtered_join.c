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

//: Filter a batch of pairs
enum {
    FILTER_WORK = 16 ///< units of work that the filter of a pair takes
};

typedef struct filter_job {
    const tf_surface *surface;
    int corners, others; ///< of the elements of each pair
    bool simple;         ///< whether a free vertex is all that a pair needs
} filter_job;

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
    bool filters = asks || surface->inverse_mass;
    filter_job job = {.surface = surface,
                      .corners = corners,
                      .others = others,
                      .simple = !asks && surface->inverse_mass &&
                                corners + others <= surface->axes + 1};
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
