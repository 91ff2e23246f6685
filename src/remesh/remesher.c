//: Count operations
#include "remesh/remesher.h"

#include "remesh/measure.h"
#include "surgery/star.h"

void tf_remesher_free(tf_remesher *remesher)
{
    tf_original_free(&remesher->original);
    tf_buffer_free(&remesher->row);
    tf_sort_memory_free(&remesher->sorting);
}

size_t tf_remesher_memory(const tf_remesher *remesher)
{
    return remesher->row.bytes + tf_sort_memory_bytes(&remesher->sorting);
}

void tf_remesher_count(tf_remesher *remesher, tf_operation operation,
                       tf_outcome outcome)
{
    const tf_remesh_options *options = &remesher->options;
    remesher->report.tried[operation][outcome]++;
    if (options->progress)
        options->progress(options->context, &remesher->report);
}

//: Order edges by length
static bool is_shorter(const void *first, const void *second)
{
    const tf_edge_row *a = first, *b = second;
    if (a->length != b->length)
        return a->length < b->length;
    return a->a != b->a ? a->a < b->a : a->b < b->b;
}

//: List edges
/// Each edge is listed at one of its two corners.
static bool is_first(const tf_adaptive_surface *surface, int corner)
{
    return tf_vertex_at(surface, corner) <
               tf_vertex_at(surface, tf_corner_after(corner)) ||
           tf_is_boundary_edge(surface, corner);
}

/// False if there is no memory.
static bool list_edges(tf_remesher *remesher, double low, double high)
{
    const tf_adaptive_surface *surface = remesher->surface;
    remesher->rows = 0;
    if (!tf_buffer_extend(&remesher->row, 3 * (size_t)surface->triangles,
                          sizeof(tf_edge_row)))
        return false;
    tf_edge_row *row = remesher->row.data;
    for (int c = 0; c < 3 * surface->triangles; c++) {
        if (!tf_is_triangle(surface, c / 3) || !is_first(surface, c))
            continue;
        int a = tf_vertex_at(surface, c);
        int b = tf_vertex_at(surface, tf_corner_after(c));
        double length = tf_length_of(surface, a, b);
        if (length >= low && length <= high)
            row[remesher->rows++] = (tf_edge_row){length, a, b};
    }
    return tf_list_sort(&remesher->row, (size_t)remesher->rows, sizeof *row,
                        is_shorter, &remesher->sorting, NULL);
}

//: Visit edges
tf_status tf_remesher_visit(tf_remesher *remesher, double low, double high,
                            tf_edge_order order,
                            tf_status visit(tf_remesher *remesher,
                                            const tf_edge_row *edge))
{
    if (!list_edges(remesher, low, high))
        return TF_OUT_OF_MEMORY;
    const tf_edge_row *row = remesher->row.data;
    tf_status status = TF_OK;
    int last = remesher->rows - 1;
    for (int i = 0; i <= last && status == TF_OK; i++)
        status =
            visit(remesher, &row[order == TF_LONGEST_FIRST ? last - i : i]);
    return status;
}
