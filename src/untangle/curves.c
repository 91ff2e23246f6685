//: Include what curves need
#include "untangle/curves.h"

//: Find the point where an edge passes through a facet
static tf_curve_point point_of(const tf_neighbors *all, const double x[],
                               int edge, int facet)
{
    const int *end = all->edge + 2 * (ptrdiff_t)edge;
    tf_vector a = tf_place(all, x, end[0]), b = tf_place(all, x, end[1]);
    tf_vector corner =
        tf_place(all, x, all->facet[(ptrdiff_t)all->axes * facet]);
    tf_curve_point own = {.edge = edge, .facet = facet, .at = 0.5};
    own.normal = tf_facet_normal(all, x, facet);
    double low = tf_vector_dot(own.normal, tf_vector_difference(a, corner));
    double high = tf_vector_dot(own.normal, tf_vector_difference(b, corner));
    own.rise = high - low;
    // Rounding may have put both ends on one side.
    if (low != high && -low / own.rise >= 0 && -low / own.rise <= 1)
        own.at = -low / own.rise;
    own.place = tf_vector_sum(tf_vector_scaled(1 - own.at, a), own.at, b);
    return own;
}

//: List the points of crossings
/// Adds the points of a crossing, at most two, to a list; returns how many.
static int list_points(const tf_neighbors *all, const double x[],
                       const tf_crossing *crossing, tf_curve_point *to)
{
    const int *v = crossing->vertex;
    if (crossing->kind == TF_EDGE_THROUGH_TRIANGLE) {
        *to = point_of(all, x, tf_edge_of(all, v[0], v[1]),
                       tf_triangle_of(all, v[2], v[3], v[4]));
        return 1;
    }
    if (all->axes == 3)
        return 0;
    int first = tf_edge_of(all, v[0], v[1]),
        other = tf_edge_of(all, v[2], v[3]);
    to[0] = point_of(all, x, first, other);
    to[1] = point_of(all, x, other, first);
    return 2;
}

bool tf_curves_find(tf_curves *curves, const tf_tangle *tangle,
                    const double x[])
{
    const tf_crossings *all = &tangle->crossings;
    if (!tf_buffer_reserve(&curves->storage, 2 * all->count + 1,
                           sizeof(tf_curve_point)))
        return false;
    tf_curve_point *point = curves->storage.data;
    size_t count = 0;
    for (size_t i = 0; i < all->count; i++)
        count += (size_t)list_points(&tangle->near, x, &all->crossing[i],
                                     point + count);
    curves->count = count;
    curves->point = point;
    return true;
}

void tf_curves_free(tf_curves *curves)
{
    tf_buffer_free(&curves->storage);
}
