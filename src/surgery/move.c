//: Sweep the star of a vertex
#include "surgery/move.h"

#include "base/require.h"
#include "surgery/operations.h"
#include "surgery/request.h"
#include "surgery/star.h"

#include <string.h>

/// Moves the triangle of a corner there to another vertex.
static void sweep_triangle(tf_adaptive *of, int corner, int to)
{
    int from = tf_vertex_at(of, corner);
    int x = tf_vertex_at(of, tf_corner_after(corner));
    int y = tf_vertex_at(of, tf_corner_before(corner));
    tf_surgery_remove(of, corner / 3);
    tf_surgery_add(of, to, x, y);
    tf_surgery_sweep(of, from, to, x, y);
    tf_surgery_keep(of, tf_corner_after(corner));
}

//: Try a move
/// Tries the surgery that gives the triangles of a vertex to one placed
/// elsewhere.
static tf_outcome try_move(tf_adaptive *of, int vertex, const double place[3])
{
    int c = tf_first_corner(of, vertex);
    if (c == TF_NONE || tf_is_lone(of, c / 3))
        return TF_IMPOSSIBLE;
    int moved = tf_surgery_place(of, place);
    for (; c != TF_NONE; c = tf_next_corner(of, c))
        sweep_triangle(of, c, moved);
    tf_surgery_move(of, vertex, moved);
    return tf_surgery_try(of);
}

//: Put a vertex elsewhere
void tf_vertex_put(tf_adaptive *of, int vertex, const double place[3])
{
    memcpy((double *)of->position.data + 3 * (ptrdiff_t)vertex, place,
           3 * sizeof *place);
    int c = tf_first_corner(of, vertex);
    for (; c != TF_NONE; c = tf_next_corner(of, c))
        tf_hierarchy_change(&of->boxes, c / 3,
                            tf_cuboid_of(of, 3, tf_triangle(of, c / 3)));
}

//: Move a vertex
tf_status tf_adaptive_move(tf_adaptive *surface, int vertex,
                           const double place[3], tf_outcome *outcome)
{
    TF_REQUIRE(place);
    tf_status status =
        tf_request_check(surface, vertex, vertex, place, outcome);
    if (status != TF_OK)
        return status;
    if (!tf_surgery_begin(surface, tf_star_size(surface, vertex)))
        return TF_OUT_OF_MEMORY;
    *outcome = try_move(surface, vertex, place);
    if (*outcome == TF_COMMITTED)
        tf_vertex_put(surface, vertex, place);
    return TF_OK;
}
