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
static bool is_first(const tf_adaptive *of, int corner)
{
    return tf_vertex_at(of, corner) <
               tf_vertex_at(of, tf_corner_after(corner)) ||
           tf_is_bare(of, corner);
}

bool tf_remesher_list(tf_remesher *of, double low, double high)
{
    const tf_adaptive *surface = of->of;
    of->rows = 0;
    if (!tf_buffer_extend(&of->row, 3 * (size_t)surface->triangles,
                          sizeof(tf_edge_row)))
        return false;
    tf_edge_row *row = of->row.data;
    for (int c = 0; c < 3 * surface->triangles; c++) {
        if (!tf_is_triangle(surface, c / 3) || !is_first(surface, c))
            continue;
        int a = tf_vertex_at(surface, c);
        int b = tf_vertex_at(surface, tf_corner_after(c));
        double length = tf_length_of(surface, a, b);
        if (length >= low && length <= high)
            row[of->rows++] = (tf_edge_row){length, a, b};
    }
    if (of->rows > 0)
        qsort(row, (size_t)of->rows, sizeof *row, compare_edges);
    return true;
}

//: Count operations
void tf_remesher_count(tf_remesher *of, tf_operation operation,
                       tf_outcome outcome)
{
    of->report->tried[operation][outcome]++;
    if (of->options->progress)
        of->options->progress(of->options->context, of->report);
}

//: Project to the original
tf_vector tf_remesher_project(tf_remesher *of, tf_vector point)
{
    tf_vector projected = point;
    double distance = tf_original_nearest(&of->original, point.x, projected.x);
    return distance < of->edge ? projected : point;
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

static bool has_vertex_too(const tf_adaptive *of, int corner, int other)
{
    return tf_vertex_at(of, tf_corner_after(corner)) == other ||
           tf_vertex_at(of, tf_corner_before(corner)) == other;
}

bool tf_star_stays_good(const tf_remesher *of, int vertex, int other,
                        tf_vector place)
{
    judgment all = {.before = 1, .after = 1};
    int c = tf_first_corner(of->of, vertex);
    for (; c != TF_NONE; c = tf_next_corner(of->of, c)) {
        if (has_vertex_too(of->of, c, other))
            continue;
        tf_shape before = tf_shape_of(of->of, c / 3), after = before;
        after.corner[c % 3] = place;
        judge_triangle(&all, &before, &after);
    }
    return !all.turned && (all.after >= all.before || all.after >= 0.6);
}
