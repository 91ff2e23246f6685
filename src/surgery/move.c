//: Sweep the star of a vertex
#include "surgery/move.h"

#include "base/require.h"
#include "surgery/request.h"
#include "surgery/star.h"
#include "surgery/surgery.h"
#include "surgery/trial.h"

/// Moves the triangle of a corner there to another vertex.
static void sweep_triangle(tf_adaptive_surface *surface, int corner, int to)
{
    int from = tf_vertex_at(surface, corner);
    int x = tf_vertex_at(surface, tf_corner_after(corner));
    int y = tf_vertex_at(surface, tf_corner_before(corner));
    tf_surgery_remove(surface, corner / 3);
    tf_surgery_add(surface, to, x, y);
    tf_surgery_sweep(surface, from, to, x, y);
    tf_surgery_keep(surface, tf_corner_after(corner));
}

//: Try a move
/// Tries the surgery that gives the triangles of a vertex to one placed
/// elsewhere.
static tf_outcome try_move(tf_adaptive_surface *surface, int vertex,
                           const double position[3])
{
    int c = tf_first_corner(surface, vertex);
    if (c == TF_NONE || tf_is_frozen(surface, vertex) ||
        tf_is_isolated(surface, c / 3))
        return TF_IMPOSSIBLE;
    int moved = tf_surgery_place(surface, position);
    for (; c != TF_NONE; c = tf_next_corner(surface, c))
        sweep_triangle(surface, c, moved);
    tf_surgery_move(surface, vertex, moved);
    return tf_surgery_try(surface);
}

//: Move a vertex
tf_status tf_adaptive_move(tf_adaptive_surface *surface, int vertex,
                           const double position[3], tf_outcome *outcome)
{
    TF_REQUIRE(position);
    tf_status status =
        tf_request_check(surface, vertex, vertex, position, outcome);
    if (status != TF_OK)
        return status;
    if (!tf_surgery_begin(surface, tf_star_size(surface, vertex)))
        return TF_OUT_OF_MEMORY;
    *outcome = try_move(surface, vertex, position);
    if (*outcome == TF_COMMITTED)
        tf_vertex_put(surface, vertex, position);
    return TF_OK;
}
