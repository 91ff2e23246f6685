//: Find out whether an edge may collapse
#include "surgery/collapse.h"

#include "base/require.h"
#include "surgery/move.h"
#include "surgery/request.h"
#include "surgery/star.h"
#include "surgery/surgery.h"
#include "surgery/trial.h"

#include <string.h>

/// Whether the vertex opposite to the edge of a corner keeps enough triangles:
/// a ring of three, or a fan of one.  A frozen vertex may have several fans.
static bool apex_survives(const tf_adaptive_surface *surface, int corner)
{
    int before = tf_corner_before(corner);
    int apex = tf_vertex_at(surface, before);
    if (tf_is_boundary_edge(surface, tf_corner_after(corner)) &&
        tf_is_boundary_edge(surface, before))
        return false;
    return tf_is_boundary_vertex(surface, apex) ||
           tf_star_size(surface, apex) >= 4;
}

//: Find out what would be left
/// Whether only an isolated triangle would be left.
static bool leaves_isolated_triangle(const tf_adaptive_surface *surface,
                                     int from, int edges)
{
    int boundary = 0, c = tf_first_corner(surface, from);
    for (; c != TF_NONE; c = tf_next_corner(surface, c))
        boundary += tf_is_boundary_edge(surface, tf_corner_after(c));
    int size = tf_star_size(surface, from);
    return size == edges + 1 && boundary == size;
}

/// The corners where the edge begins, in each direction.
static bool may_collapse(const tf_adaptive_surface *surface, int from, int to,
                         const int corner[2])
{
    int edges = 0;
    for (int i = 0; i < 2; i++) {
        if (corner[i] == TF_NONE)
            continue;
        if (!apex_survives(surface, corner[i]))
            return false;
        edges++;
    }
    return edges > 0 && tf_common_neighbors(surface, from, to) == edges &&
           (edges == 1 || !tf_is_boundary_vertex(surface, from)) &&
           !leaves_isolated_triangle(surface, from, edges);
}

//: Describe a collapse
static bool has_vertex(const tf_adaptive_surface *surface, int triangle,
                       int vertex)
{
    const int *v = tf_triangle(surface, triangle);
    return v[0] == vertex || v[1] == vertex || v[2] == vertex;
}

static void collapse_triangle(tf_adaptive_surface *surface, int corner, int to)
{
    int from = tf_vertex_at(surface, corner);
    int x = tf_vertex_at(surface, tf_corner_after(corner));
    int y = tf_vertex_at(surface, tf_corner_before(corner));
    tf_surgery_remove(surface, corner / 3);
    tf_surgery_keep(surface, tf_corner_after(corner));
    if (has_vertex(surface, corner / 3, to))
        return;
    tf_surgery_add(surface, to, x, y);
    tf_surgery_sweep(surface, from, to, x, y);
}

//: Collapse an edge as far as it is possible
static tf_outcome collapse(tf_adaptive_surface *surface, int from, int to)
{
    int corner[] = {tf_find_edge(surface, from, to),
                    tf_find_edge(surface, to, from)};
    if (tf_is_frozen(surface, from) || !may_collapse(surface, from, to, corner))
        return TF_IMPOSSIBLE;
    int c = tf_first_corner(surface, from);
    for (; c != TF_NONE; c = tf_next_corner(surface, c))
        collapse_triangle(surface, c, to);
    tf_outcome outcome = tf_surgery_try(surface);
    if (outcome == TF_COMMITTED)
        tf_surgery_commit(surface);
    return outcome;
}

//: Collapse an edge
tf_status tf_adaptive_collapse(tf_adaptive_surface *surface, int from, int to,
                               tf_outcome *outcome)
{
    tf_status status = tf_request_check(surface, from, to, NULL, outcome);
    if (status != TF_OK)
        return status;
    if (!tf_surgery_begin(surface, tf_star_size(surface, from)))
        return TF_OUT_OF_MEMORY;
    *outcome = collapse(surface, from, to);
    return TF_OK;
}

//: Collapse an edge to a position
tf_status tf_adaptive_collapse_to(tf_adaptive_surface *surface, int from,
                                  int to, const double position[3],
                                  tf_outcome *outcome)
{
    TF_REQUIRE(position);
    tf_status status = tf_request_check(surface, from, to, position, outcome);
    if (status != TF_OK)
        return status;
    double before[3];
    memcpy(before, tf_vertex_coordinates(surface, to), sizeof before);
    if (memcmp(before, position, sizeof before) == 0)
        return tf_adaptive_collapse(surface, from, to, outcome);
    status = tf_adaptive_move(surface, to, position, outcome);
    if (status != TF_OK || *outcome != TF_COMMITTED)
        return status;
    status = tf_adaptive_collapse(surface, from, to, outcome);
    if (*outcome != TF_COMMITTED)
        tf_vertex_put(surface, to, before);
    return status;
}
