//: Recognize a sharp edge
#include "remesh/sharp_edges.h"

#include "remesh/measure.h"
#include "surgery/star.h"

bool tf_is_sharp_edge(const tf_adaptive_surface *surface, int corner)
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

//: Collect the sharp edges at a vertex
typedef struct sharp_edges {
    int count;
    tf_vector sum; ///< of their unit vectors
} sharp_edges;

static void add_edge(const tf_adaptive_surface *surface, int vertex, int other,
                     sharp_edges *all)
{
    tf_vector along = tf_vector_difference(tf_position_of(surface, other),
                                           tf_position_of(surface, vertex));
    all->sum = tf_vector_sum(all->sum, 1 / tf_vector_length(along), along);
    all->count++;
}

/// Each edge leads away from the vertex in one triangle, but for one on the
/// boundary that only leads to it.
static sharp_edges sharp_edges_at(const tf_adaptive_surface *surface,
                                  int vertex)
{
    sharp_edges all = {0};
    int c = tf_first_corner(surface, vertex);
    for (; c != TF_NONE; c = tf_next_corner(surface, c)) {
        int before = tf_corner_before(c);
        if (tf_is_sharp_edge(surface, c))
            add_edge(surface, vertex, tf_vertex_at(surface, tf_corner_after(c)),
                     &all);
        if (tf_is_boundary_edge(surface, before))
            add_edge(surface, vertex, tf_vertex_at(surface, before), &all);
    }
    return all;
}

//: Find the freedom of a vertex
tf_freedom tf_freedom_of(const tf_adaptive_surface *surface, int vertex)
{
    sharp_edges all = sharp_edges_at(surface, vertex);
    if (all.count == 0)
        return TF_FREE;
    // Two unit vectors in nearly opposite directions cancel.
    bool straight = all.count == 2 && tf_vector_length(all.sum) < 0.5;
    return straight ? TF_ALONG_SHARP_EDGE : TF_HELD;
}

//: Let the freer vertex go
bool tf_collapse_freer(const tf_adaptive_surface *surface, int corner,
                       const tf_freedom freedom[2], bool sharp,
                       tf_edge_collapse *collapse)
{
    const int end[] = {tf_vertex_at(surface, corner),
                       tf_vertex_at(surface, tf_corner_after(corner))};
    int from = freedom[1] > freedom[0];
    *collapse = (tf_edge_collapse){end[from], end[1 - from],
                                   tf_position_of(surface, end[1 - from])};
    return freedom[from] == TF_FREE ||
           (freedom[from] == TF_ALONG_SHARP_EDGE && sharp);
}
