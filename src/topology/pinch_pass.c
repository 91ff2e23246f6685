//: List the loops of three edges
#include "topology/pinch_pass.h"

#include "remesh/measure.h"
#include "surgery/star.h"
#include "topology/pinch.h"

/// Three vertices, with short edges between them and no triangle.
typedef struct tf_loop {
    double length; ///< of the three edges together
    int vertex[3];
} tf_loop;

static bool is_shorter(const void *first, const void *second)
{
    const tf_loop *a = first, *b = second;
    if (a->length != b->length)
        return a->length < b->length;
    for (int i = 0; i < 3; i++)
        if (a->vertex[i] != b->vertex[i])
            return a->vertex[i] < b->vertex[i];
    return false;
}

static bool add_loop(tf_reconnector *reconnector, int a, int b, int c)
{
    if (!tf_buffer_extend(&reconnector->candidate,
                          (size_t)reconnector->candidates + 1, sizeof(tf_loop)))
        return false;
    double length = tf_length_of(reconnector->surface, a, b) +
                    tf_length_of(reconnector->surface, b, c) +
                    tf_length_of(reconnector->surface, c, a);
    ((tf_loop *)reconnector->candidate.data)[reconnector->candidates++] =
        (tf_loop){length, {a, b, c}};
    return true;
}

//: Find the loops at an edge
/// Whether the edge from a corner on is the short one of a loop in which
/// `third` is the last vertex.
static bool closes_loop(const tf_reconnector *reconnector, int a, int b,
                        int third)
{
    double most = reconnector->lengths.pinch;
    int left = tf_find_edge(reconnector->surface, a, b),
        right = tf_find_edge(reconnector->surface, b, a);
    return right != TF_NONE &&
           tf_find_edge(reconnector->surface, third, b) != TF_NONE &&
           tf_vertex_at(reconnector->surface, tf_corner_before(left)) !=
               third &&
           tf_vertex_at(reconnector->surface, tf_corner_before(right)) !=
               third &&
           tf_length_of(reconnector->surface, a, third) < most &&
           tf_length_of(reconnector->surface, b, third) < most;
}

/// A loop is listed once, with its vertices in order.
static bool list_loops(tf_reconnector *reconnector, int corner)
{
    int a = tf_vertex_at(reconnector->surface, corner);
    int b = tf_vertex_at(reconnector->surface, tf_corner_after(corner));
    if (a >= b ||
        tf_length_of(reconnector->surface, a, b) >= reconnector->lengths.pinch)
        return true;
    for (int c = tf_first_corner(reconnector->surface, a); c != TF_NONE;
         c = tf_next_corner(reconnector->surface, c)) {
        int third = tf_vertex_at(reconnector->surface, tf_corner_after(c));
        if (third > b && closes_loop(reconnector, a, b, third) &&
            !add_loop(reconnector, a, b, third))
            return false;
    }
    return true;
}

//: Find all loops
enum {
    WATCHED = 64 ///< corners between two looks at the watch
};

static tf_status list_all_loops(tf_reconnector *reconnector)
{
    const tf_adaptive_surface *surface = reconnector->surface;
    reconnector->candidates = 0;
    tf_watch_stage(surface->watch, "necks", 3 * (size_t)surface->triangles);
    for (int c = 0; c < 3 * surface->triangles; c++) {
        if (c % WATCHED == 0 && !tf_watch_done(surface->watch, WATCHED))
            return TF_CANCELLED;
        if (tf_is_triangle(surface, c / 3) && !list_loops(reconnector, c))
            return TF_OUT_OF_MEMORY;
    }
    return tf_reconnector_sort(reconnector, sizeof(tf_loop), is_shorter);
}

//: Look to the left of a loop
/// The middle of the neighbors of a vertex of the loop that are to its left;
/// returns how many.
static int left_middle(const tf_adaptive_surface *surface, const int loop[3],
                       int i, tf_vector *middle)
{
    int count = 0, end, from = loop[i], last = loop[(i + 2) % 3];
    tf_vector sum = {{0}};
    int c = tf_find_edge(surface, from, loop[(i + 1) % 3]);
    while ((end = tf_vertex_at(surface, tf_corner_before(c))) != last) {
        sum = tf_vector_sum(sum, 1, tf_position_of(surface, end));
        count++;
        c = tf_find_edge(surface, from, end);
    }
    *middle = tf_vector_scaled(1.0 / count, sum);
    return count;
}

/// False if there is only a tip of three triangles: that is no neck.
static bool find_middles(const tf_adaptive_surface *surface, const int loop[3],
                         tf_vector middle[3])
{
    int most = 0;
    for (int i = 0; i < 3; i++) {
        int count = left_middle(surface, loop, i, &middle[i]);
        most = count > most ? count : most;
    }
    return most > 1;
}

//: Choose how far the left side retreats
/// The part of the way to the middles on which the two sides get so far apart
/// that they are not merged at once; but no more than most of it.
static double wanted_part(const tf_reconnector *reconnector, const int loop[3],
                          const tf_vector middle[3])
{
    tf_vector x[3], ways = {{0}};
    for (int i = 0; i < 3; i++) {
        x[i] = tf_position_of(reconnector->surface, loop[i]);
        ways =
            tf_vector_sum(ways, 1.0 / 3, tf_vector_difference(middle[i], x[i]));
    }
    tf_vector normal = tf_vector_cross(tf_vector_difference(x[1], x[0]),
                                       tf_vector_difference(x[2], x[0]));
    double far = fabs(tf_vector_dot(ways, normal)) / tf_vector_length(normal);
    return fmin(0.75, 1.1 * reconnector->lengths.apart / far);
}

//: Pinch a loop by so much
/// The new vertices go this part of the way to the middles.
static tf_status pinch_by(tf_reconnector *reconnector, const int loop[3],
                          const tf_vector middle[3], double part,
                          tf_outcome *outcome)
{
    int all[6] = {loop[0], loop[1], loop[2]};
    double position[9], before = tf_volume_at(reconnector->surface, 3, loop);
    for (int i = 0; i < 9; i++) {
        double x = tf_position_of(reconnector->surface, loop[i / 3]).x[i % 3];
        position[i] = (x + part * (middle[i / 3].x[i % 3] - x)) /
                      reconnector->surface->scale;
    }
    tf_status status = tf_adaptive_pinch(reconnector->surface, loop, position,
                                         all + 3, outcome);
    if (status != TF_OK)
        return status;
    int count = *outcome == TF_COMMITTED ? 6 : 3;
    tf_reconnector_count(reconnector, TF_PINCH, *outcome,
                         tf_volume_at(reconnector->surface, count, all) -
                             before);
    return TF_OK;
}

//: Pinch a loop to its left
/// By less and less, until it is done.
static tf_status pinch_side(tf_reconnector *reconnector, const int loop[3],
                            const tf_vector middle[3], tf_outcome *outcome)
{
    tf_status status = TF_OK;
    *outcome = TF_NO_OUTCOME;
    for (double part = wanted_part(reconnector, loop, middle);
         part > 0.01 && status == TF_OK && *outcome != TF_COMMITTED &&
         *outcome != TF_IMPOSSIBLE;
         part /= 3)
        status = pinch_by(reconnector, loop, middle, part, outcome);
    return status;
}

//: Pinch a loop on either side
/// Whether it is still a loop, that is not on the boundary.
static bool is_still_loop(const tf_reconnector *reconnector, const int v[3])
{
    for (int i = 0; i < 3; i++)
        if (tf_find_edge(reconnector->surface, v[i], v[(i + 1) % 3]) ==
                TF_NONE ||
            tf_is_boundary_vertex(reconnector->surface, v[i]) ||
            tf_is_frozen(reconnector->surface, v[i]))
            return false;
    return closes_loop(reconnector, v[0], v[1], v[2]);
}

static tf_status pinch_loop(tf_reconnector *reconnector, const int v[3])
{
    const int back[] = {v[0], v[2], v[1]};
    tf_vector left[3], right[3];
    if (!is_still_loop(reconnector, v) ||
        !find_middles(reconnector->surface, v, left) ||
        !find_middles(reconnector->surface, back, right))
        return TF_OK;
    tf_outcome outcome;
    tf_status status = pinch_side(reconnector, v, left, &outcome);
    if (status == TF_OK && outcome != TF_COMMITTED)
        status = pinch_side(reconnector, back, right, &outcome);
    return status;
}

//: Pinch all loops
tf_status tf_pinch_pass(tf_reconnector *reconnector)
{
    tf_watch *watch = reconnector->surface->watch;
    tf_status status = list_all_loops(reconnector);
    const tf_loop *loop = reconnector->candidate.data;
    tf_watch_stage(watch, "pinching", (size_t)reconnector->candidates);
    for (int i = 0; i < reconnector->candidates && status == TF_OK; i++)
        status = tf_watch_done(watch, 1)
                     ? pinch_loop(reconnector, loop[i].vertex)
                     : TF_CANCELLED;
    return status;
}
