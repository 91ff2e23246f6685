//: Order edges by length
#include "remesh/remesher.h"

#include "remesh/measure.h"
#include "surgery/star.h"

#include <stdlib.h>

static int compare_edges(const void *first, const void *second)
{
    const tf_edge_row *a = first, *b = second;
    if (a->length != b->length)
        return a->length < b->length ? -1 : 1;
    if (a->a != b->a)
        return a->a < b->a ? -1 : 1;
    return (a->b > b->b) - (a->b < b->b);
}

//: List the edges of a remeshing
/// Each edge is listed at one of its two corners.
static bool is_first(const tf_adaptive_surface *surface, int corner)
{
    return tf_vertex_at(surface, corner) <
               tf_vertex_at(surface, tf_corner_after(corner)) ||
           tf_is_boundary_edge(surface, corner);
}

bool tf_remesher_list(tf_remesher *remesher, double low, double high)
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
    if (remesher->rows > 0)
        qsort(row, (size_t)remesher->rows, sizeof *row, compare_edges);
    return true;
}

//: Count operations
void tf_remesher_count(tf_remesher *remesher, tf_operation operation,
                       tf_outcome outcome)
{
    remesher->report->tried[operation][outcome]++;
    if (remesher->options->progress)
        remesher->options->progress(remesher->options->context,
                                    remesher->report);
}

//: Project to the original
tf_vector tf_remesher_project(tf_remesher *remesher, tf_vector point)
{
    tf_vector projected = point;
    double distance =
        tf_original_nearest(&remesher->original, point.x, projected.x);
    return distance < remesher->edge ? projected : point;
}

//: Judge the star of a vertex
/// What is worst among some triangles, before and after a change.
typedef struct judgment {
    double before, after; ///< the least quality
    bool turned;          ///< some triangle is turned over
} judgment;

static void judge_triangle(judgment *all, const tf_shape *before,
                           const tf_shape *after)
{
    all->before = fmin(all->before, tf_shape_quality(before));
    all->after = fmin(all->after, tf_shape_quality(after));
    all->turned |=
        !tf_normals_agree(tf_shape_normal(before), tf_shape_normal(after), 0.9);
}

static bool has_vertex_too(const tf_adaptive_surface *surface, int corner,
                           int other)
{
    return tf_vertex_at(surface, tf_corner_after(corner)) == other ||
           tf_vertex_at(surface, tf_corner_before(corner)) == other;
}

bool tf_star_stays_good(const tf_remesher *remesher, int vertex, int other,
                        tf_vector place)
{
    judgment all = {.before = 1, .after = 1};
    int c = tf_first_corner(remesher->surface, vertex);
    for (; c != TF_NONE; c = tf_next_corner(remesher->surface, c)) {
        if (has_vertex_too(remesher->surface, c, other))
            continue;
        tf_shape before = tf_shape_of(remesher->surface, c / 3), after = before;
        after.corner[c % 3] = place;
        judge_triangle(&all, &before, &after);
    }
    return !all.turned && (all.after >= all.before || all.after >= 0.6);
}
