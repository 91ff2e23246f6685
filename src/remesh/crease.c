//: Recognize a crease
#include "remesh/crease.h"

#include "remesh/measure.h"
#include "surgery/star.h"

bool tf_is_crease(const tf_adaptive_surface *surface, int corner)
{
    int from = tf_vertex_at(surface, corner);
    int to = tf_vertex_at(surface, tf_corner_after(corner));
    int back = tf_find_edge(surface, to, from);
    if (back == TF_NONE)
        return true;
    tf_shape own = tf_shape_of(surface, corner / 3);
    tf_shape other = tf_shape_of(surface, back / 3);
    return !tf_normals_agree(tf_shape_normal(&own), tf_shape_normal(&other),
                             0.5);
}

//: Collect the creases at a vertex
typedef struct creases {
    int count;
    tf_vector sum; ///< of their unit vectors
} creases;

static void add_crease(const tf_adaptive_surface *surface, int vertex,
                       int other, creases *all)
{
    tf_vector along = tf_vector_difference(tf_position_of(surface, other),
                                           tf_position_of(surface, vertex));
    all->sum = tf_vector_sum(all->sum, 1 / tf_vector_length(along), along);
    all->count++;
}

/// Each edge leads away from the vertex in one triangle, but for one on the
/// boundary that only leads to it.
static creases creases_at(const tf_adaptive_surface *surface, int vertex)
{
    creases all = {0};
    int c = tf_first_corner(surface, vertex);
    for (; c != TF_NONE; c = tf_next_corner(surface, c)) {
        int before = tf_corner_before(c);
        if (tf_is_crease(surface, c))
            add_crease(surface, vertex,
                       tf_vertex_at(surface, tf_corner_after(c)), &all);
        if (tf_is_boundary_edge(surface, before))
            add_crease(surface, vertex, tf_vertex_at(surface, before), &all);
    }
    return all;
}

//: Find the freedom of a vertex
tf_freedom tf_freedom_of(const tf_adaptive_surface *surface, int vertex)
{
    creases all = creases_at(surface, vertex);
    if (all.count == 0)
        return TF_FREE;
    // Two unit vectors in nearly opposite directions cancel.
    return all.count == 2 && tf_vector_length(all.sum) < 0.5 ? TF_ALONG_CREASE
                                                             : TF_HELD;
}
