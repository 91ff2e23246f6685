//: Hold a pinch
#include "topology/pinch.h"

#include "base/require.h"
#include "surgery/request.h"
#include "surgery/star.h"
#include "surgery/surgery.h"
#include "surgery/trial.h"
#include "topology/stage.h"
#include "topology/walls.h"

/// A loop that is being cut open.
typedef struct tf_cut {
    tf_adaptive_surface *surface;
    int loop[3]; ///< its vertices
    int left[3]; ///< those of its left side: the new ones, as far as there are
    int ring[6][3]; ///< the triangles between its two sides
} tf_cut;

/// The vertex that a triangle to the left has by now instead of another one.
static int left_of(const tf_cut *cut, int vertex)
{
    for (int i = 0; i < 3; i++)
        if (cut->loop[i] == vertex)
            return cut->left[i];
    return vertex;
}

//: Find out whether a loop may be pinched
/// Whether the edge has two triangles, and neither has that third vertex.
static bool is_edge_of_loop(const tf_adaptive_surface *surface, int from,
                            int to, int third)
{
    int left = tf_find_edge(surface, from, to),
        right = tf_find_edge(surface, to, from);
    return left != TF_NONE && right != TF_NONE &&
           tf_vertex_at(surface, tf_corner_before(left)) != third &&
           tf_vertex_at(surface, tf_corner_before(right)) != third;
}

/// The triangles at a vertex on the boundary form a fan, of which a part would
/// be in two pieces.  Of a frozen one they stay.
static bool may_pinch(const tf_adaptive_surface *surface, const int loop[3])
{
    for (int i = 0; i < 3; i++)
        if (tf_is_frozen(surface, loop[i]) ||
            !is_edge_of_loop(surface, loop[i], loop[(i + 1) % 3],
                             loop[(i + 2) % 3]) ||
            tf_is_boundary_vertex(surface, loop[i]))
            return false;
    return true;
}

//: Go through the left side of a vertex
/// The corner there of the first triangle to the left of the loop.
static int first_to_the_left(const tf_cut *cut, int i)
{
    return tf_find_edge(cut->surface, cut->loop[i], cut->loop[(i + 1) % 3]);
}

/// The next one, or TF_NONE after the last.
static int next_to_the_left(const tf_cut *cut, int i, int corner)
{
    int end = tf_vertex_at(cut->surface, tf_corner_before(corner));
    if (end == cut->loop[(i + 2) % 3])
        return TF_NONE;
    return tf_find_edge(cut->surface, cut->loop[i], end);
}

//: Take a triangle from a vertex
/// It may already be that of another new vertex.
static void take_triangle(tf_cut *cut, int corner)
{
    int now[3];
    bool moved = false;
    for (int i = 0; i < 3; i++) {
        int vertex = tf_vertex_at(cut->surface, corner / 3 * 3 + i);
        now[i] = left_of(cut, vertex);
        moved |= now[i] != vertex;
    }
    if (moved)
        tf_surgery_withdraw(cut->surface, now[0], now[1], now[2]);
    else
        tf_surgery_remove(cut->surface, corner / 3);
}

//: Give a triangle to a new vertex
static void give_triangle(tf_cut *cut, int corner, int to)
{
    int from = tf_vertex_at(cut->surface, corner);
    int x = left_of(cut, tf_vertex_at(cut->surface, tf_corner_after(corner)));
    int y = left_of(cut, tf_vertex_at(cut->surface, tf_corner_before(corner)));
    tf_surgery_add(cut->surface, to, x, y);
    tf_surgery_sweep(cut->surface, from, to, x, y);
    tf_surgery_keep(cut->surface, tf_corner_after(corner));
}

//: Open the loop at a vertex
/// Adds a triangle between the two sides of the loop.
static void add_to_ring(tf_cut *cut, int index, int a, int b, int c)
{
    int *v = cut->ring[index];
    v[0] = a;
    v[1] = b;
    v[2] = c;
    tf_surgery_add(cut->surface, a, b, c);
}

/// A collapse of the new vertex into the old one, backwards.
static tf_outcome open_vertex(tf_cut *cut, int i, const double position[3])
{
    int from = cut->loop[i], to = tf_surgery_place(cut->surface, position);
    int before = cut->left[(i + 2) % 3], after = cut->left[(i + 1) % 3], c;
    for (c = first_to_the_left(cut, i); c != TF_NONE;
         c = next_to_the_left(cut, i, c))
        take_triangle(cut, c);
    for (c = first_to_the_left(cut, i); c != TF_NONE;
         c = next_to_the_left(cut, i, c))
        give_triangle(cut, c, to);
    add_to_ring(cut, 2 * i, from, after, to);
    add_to_ring(cut, 2 * i + 1, before, from, to);
    tf_outcome outcome = tf_surgery_try(cut->surface);
    tf_surgery_end_stage(cut->surface);
    cut->left[i] = to;
    return outcome;
}

//: Close both sides of the loop
static tf_outcome close_sides(tf_cut *cut)
{
    tf_walls walls = {0};
    for (int i = 0; i < 6; i++) {
        const int *v = cut->ring[i];
        tf_surgery_withdraw(cut->surface, v[0], v[1], v[2]);
        tf_walls_add(&walls, cut->surface, v[0], v[1], v[2]);
    }
    tf_surgery_add(cut->surface, cut->loop[0], cut->loop[1], cut->loop[2]);
    tf_surgery_add(cut->surface, cut->left[0], cut->left[2], cut->left[1]);
    return tf_walls_try(&walls, cut->surface);
}

//: Describe a pinch
static tf_outcome try_pinch(tf_cut *cut, const double position[9])
{
    tf_outcome outcome = TF_COMMITTED;
    for (int i = 0; i < 3 && outcome == TF_COMMITTED; i++)
        outcome = open_vertex(cut, i, position + 3 * (ptrdiff_t)i);
    return outcome == TF_COMMITTED ? close_sides(cut) : outcome;
}

/// Makes room for all stages.
static bool begin_pinch(tf_adaptive_surface *surface, const int loop[3])
{
    int most = 8;
    for (int i = 0; i < 3; i++)
        most += tf_star_size(surface, loop[i]);
    return tf_surgery_begin(surface, most);
}

//: Pinch a loop as far as it is possible
static tf_outcome pinch(tf_adaptive_surface *surface, const int loop[3],
                        const double position[9], int vertex[3])
{
    tf_cut cut = {.surface = surface};
    if (!may_pinch(surface, loop))
        return TF_IMPOSSIBLE;
    for (int i = 0; i < 3; i++)
        cut.loop[i] = cut.left[i] = loop[i];
    tf_outcome outcome = try_pinch(&cut, position);
    if (outcome != TF_COMMITTED)
        return outcome;
    tf_surgery_accept(surface);
    tf_surgery_commit(surface);
    for (int i = 0; i < 3; i++)
        vertex[i] = cut.left[i];
    return outcome;
}

//: Pinch a loop
tf_status tf_adaptive_pinch(tf_adaptive_surface *surface, const int loop[3],
                            const double position[9], int vertex[3],
                            tf_outcome *outcome)
{
    TF_REQUIRE(loop && position && vertex);
    tf_status status = TF_OK;
    for (int i = 0; i < 3 && status == TF_OK; i++)
        status = tf_request_check(surface, loop[i], loop[(i + 1) % 3],
                                  position + 3 * (ptrdiff_t)i, outcome);
    if (status != TF_OK)
        return status;
    if (!begin_pinch(surface, loop))
        return TF_OUT_OF_MEMORY;
    *outcome = pinch(surface, loop, position, vertex);
    return TF_OK;
}
