//: Count operations
#include "remesh/remesher.h"

#include "remesh/measure.h"
#include "surgery/star.h"

void tf_remesher_free(tf_remesher *remesher)
{
    tf_original_free(&remesher->original);
    tf_trace_free(&remesher->trace);
    tf_sharp_edges_free(&remesher->sharp);
    tf_sharp_edges_free(&remesher->sharp_before);
    tf_buffer_free(&remesher->corner_origin);
    tf_buffer_free(&remesher->map);
    tf_buffer_free(&remesher->row);
    tf_sort_memory_free(&remesher->sorting);
}

size_t tf_remesher_memory(const tf_remesher *remesher)
{
    const tf_sharp_edges *sharp = &remesher->sharp;
    return remesher->row.bytes + remesher->map.bytes + sharp->first.bytes +
           sharp->link.bytes + sharp->held.bytes +
           tf_sort_memory_bytes(&remesher->sorting);
}

void tf_remesher_count(tf_remesher *remesher, tf_operation operation,
                       tf_outcome outcome)
{
    remesher->report.tried[operation][outcome]++;
}

//: Close the gaps of a remeshing
tf_status tf_remesher_compact(tf_remesher *remesher)
{
    int before = remesher->surface->vertices;
    if (!tf_buffer_extend(&remesher->map, (size_t)before, sizeof(int)))
        return TF_OUT_OF_MEMORY;
    int *map = remesher->map.data;
    tf_status status = tf_adaptive_compact(remesher->surface, map);
    if (status != TF_OK)
        return status;
    tf_sharp_edges_compact(&remesher->sharp, map);
    if (tf_trace_goes(&remesher->trace))
        tf_trace_compact(&remesher->trace, before, map);
    return TF_OK;
}

//: Find target lengths
double tf_target_at(const tf_remesher *remesher, int vertex)
{
    if (!remesher->target)
        return remesher->edge;
    const tf_origin *origin =
        (const tf_origin *)remesher->trace.origin.data + vertex;
    const int *corner =
        tf_triangle(remesher->original.surface, origin->triangle);
    double target = 0;
    for (int i = 0; i < 3; i++)
        target += origin->barycentric[i] * remesher->target[corner[i]];
    return target;
}

double tf_target_between(const tf_remesher *remesher, int a, int b)
{
    return remesher->target
               ? (tf_target_at(remesher, a) + tf_target_at(remesher, b)) / 2
               : remesher->edge;
}

//: Order edges by length
static bool is_shorter(const void *first, const void *second)
{
    const tf_edge_row *a = first, *b = second;
    if (a->ratio != b->ratio)
        return a->ratio < b->ratio;
    return a->a != b->a ? a->a < b->a : a->b < b->b;
}

//: List each edge once
/// Each edge is listed at one of its two corners, unless it is left alone.
static bool is_listed(const tf_adaptive_surface *surface, int corner)
{
    int from = tf_vertex_at(surface, corner);
    int to = tf_vertex_at(surface, tf_corner_after(corner));
    return !tf_is_frozen_edge(surface, from, to) &&
           (from < to || tf_is_boundary_edge(surface, corner));
}

//: List an edge of a length
static void list_edge(tf_remesher *remesher, int corner, double low,
                      double high)
{
    const tf_adaptive_surface *surface = remesher->surface;
    int a = tf_vertex_at(surface, corner);
    int b = tf_vertex_at(surface, tf_corner_after(corner));
    double ratio =
        tf_length_of(surface, a, b) / tf_target_between(remesher, a, b);
    if (ratio >= low && ratio <= high)
        ((tf_edge_row *)remesher->row.data)[remesher->rows++] =
            (tf_edge_row){ratio, a, b};
}

//: List all edges in order
static tf_status list_edges(tf_remesher *remesher, double low, double high)
{
    const tf_adaptive_surface *surface = remesher->surface;
    tf_watch *watch = surface->watch;
    remesher->rows = 0;
    if (!tf_buffer_extend(&remesher->row, 3 * (size_t)surface->triangles,
                          sizeof(tf_edge_row)))
        return TF_OUT_OF_MEMORY;
    for (int c = 0; c < 3 * surface->triangles; c++) {
        if (c % 1024 == 0 && !tf_watch_done(watch, 0))
            return TF_CANCELLED;
        if (tf_is_triangle(surface, c / 3) && is_listed(surface, c))
            list_edge(remesher, c, low, high);
    }
    bool sorted = tf_list_sort(&remesher->row, (size_t)remesher->rows,
                               sizeof(tf_edge_row), is_shorter,
                               &remesher->sorting, watch);
    return sorted ? TF_OK : tf_watch_failure(watch);
}

//: Visit edges
enum {
    WATCHED = 8 ///< edges that are visited before the caller is told
};

tf_status tf_remesher_visit(tf_remesher *remesher, const tf_edge_pass *pass,
                            double low, double high)
{
    tf_status status = list_edges(remesher, low, high);
    const tf_edge_row *row = remesher->row.data;
    tf_watch *watch = remesher->surface->watch;
    int last = remesher->rows - 1;
    tf_watch_stage(watch, pass->name, (size_t)remesher->rows);
    for (int i = 0; i <= last && status == TF_OK; i++) {
        if (i % WATCHED == 0 && !tf_watch_done(watch, WATCHED))
            return TF_CANCELLED;
        bool backwards = pass->order == TF_LONGEST_FIRST;
        status = pass->visit(remesher, &row[backwards ? last - i : i]);
    }
    return status;
}
