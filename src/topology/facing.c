//: Find the normals of edges
#include "topology/facing.h"

#include "linear/distance.h"
#include "remesh/measure.h"
#include "surgery/star.h"

/// The unit normal of an edge, or zero if there is none, or the edge is another
/// corner's.
static tf_vector normal_of_edge(const tf_adaptive_surface *surface, int corner)
{
    int from = tf_vertex_at(surface, corner);
    int to = tf_vertex_at(surface, tf_corner_after(corner));
    int back = from < to ? tf_find_edge(surface, to, from) : TF_NONE;
    if (back == TF_NONE)
        return (tf_vector){{0}};
    tf_shape left = tf_shape_of(surface, corner / 3);
    tf_shape right = tf_shape_of(surface, back / 3);
    tf_vector sum =
        tf_vector_sum(tf_shape_normal(&left), 1, tf_shape_normal(&right));
    double length = tf_vector_length(sum);
    return tf_vector_scaled(length > 0 ? 1 / length : 0, sum);
}

static tf_status find_normals(tf_reconnector *reconnector)
{
    const tf_adaptive_surface *surface = reconnector->surface;
    int corners = 3 * surface->triangles;
    if (!tf_buffer_extend(&reconnector->normal, (size_t)corners,
                          sizeof(tf_vector)))
        return TF_OUT_OF_MEMORY;
    tf_vector *normal = reconnector->normal.data;
    for (int c = 0; c < corners; c++) {
        if (c % 1024 == 0 && !tf_watch_done(surface->watch, 0))
            return TF_CANCELLED;
        normal[c] = tf_is_triangle(surface, c / 3) ? normal_of_edge(surface, c)
                                                   : (tf_vector){{0}};
    }
    return TF_OK;
}

//: Find out whether two edges face each other
/// The two edges of these corners, if no vertex is common.
static bool ends_of(const tf_adaptive_surface *surface, int corner, int other,
                    tf_facing_edges *pair)
{
    *pair = (tf_facing_edges){
        .first = {tf_vertex_at(surface, corner),
                  tf_vertex_at(surface, tf_corner_after(corner))},
        .second = {tf_vertex_at(surface, other),
                   tf_vertex_at(surface, tf_corner_after(other))}};
    return pair->first[0] != pair->second[0] &&
           pair->first[0] != pair->second[1] &&
           pair->first[1] != pair->second[0] &&
           pair->first[1] != pair->second[1];
}

/// From the nearest point of the first edge to that of the second.
static tf_vector gap_of(const tf_adaptive_surface *surface,
                        tf_facing_edges *pair)
{
    const int *ends[] = {pair->first, pair->second};
    tf_vector x[4], gap = {{0}};
    for (int i = 0; i < 4; i++)
        x[i] = tf_position_of(surface, ends[i / 2][i % 2]);
    tf_point_pair nearest = tf_nearest_points(2, 2, x);
    for (int i = 0; i < 4; i++)
        gap = tf_vector_sum(gap, (i < 2 ? -1 : 1) * nearest.weight[i], x[i]);
    pair->distance = nearest.distance;
    return gap;
}

static bool face_each_other(const tf_reconnector *reconnector, int corner,
                            int other, double distance, tf_facing_edges *pair)
{
    const tf_vector *normal = reconnector->normal.data;
    if (tf_vector_dot(normal[corner], normal[other]) >= -0.5 ||
        !ends_of(reconnector->surface, corner, other, pair))
        return false;
    tf_vector gap = gap_of(reconnector->surface, pair);
    return pair->distance < distance &&
           tf_vector_dot(gap, normal[corner]) > 0 &&
           tf_vector_dot(gap, normal[other]) < 0;
}

//: List what faces an edge
static bool add_facing(tf_reconnector *reconnector, const tf_facing_edges *pair)
{
    if (!tf_buffer_extend(&reconnector->candidate,
                          (size_t)reconnector->candidates + 1, sizeof *pair))
        return false;
    ((tf_facing_edges *)
         reconnector->candidate.data)[reconnector->candidates++] = *pair;
    return true;
}

/// Each pair is listed for the edge of the lower corner.
static bool list_facing(tf_reconnector *reconnector, int corner,
                        double distance)
{
    const int ends[] = {
        tf_vertex_at(reconnector->surface, corner),
        tf_vertex_at(reconnector->surface, tf_corner_after(corner))};
    double beyond = distance / reconnector->surface->scale;
    tf_aabb box = tf_aabb_of(reconnector->surface, 2, ends);
    for (int k = 0; k < 3; k++) {
        box.low[k] -= beyond;
        box.high[k] += beyond;
    }
    int *found = reconnector->surface->found.data;
    int count = tf_dynamic_tree_find(&reconnector->surface->tree, &box, found);
    tf_facing_edges pair;
    for (int i = 0; i < 3 * count; i++) {
        int other = 3 * found[i / 3] + i % 3;
        if (other > corner &&
            face_each_other(reconnector, corner, other, distance, &pair) &&
            !add_facing(reconnector, &pair))
            return false;
    }
    return true;
}

//: Order pairs of edges by distance
static bool is_nearer(const void *first, const void *second)
{
    const tf_facing_edges *a = first, *b = second;
    if (a->distance != b->distance)
        return a->distance < b->distance;
    for (int i = 0; i < 4; i++) {
        int x = i < 2 ? a->first[i] : a->second[i - 2];
        int y = i < 2 ? b->first[i] : b->second[i - 2];
        if (x != y)
            return x < y;
    }
    return false;
}

//: List all edges that face each other
enum {
    WATCHED = 16 ///< corners between two looks at the watch
};

static tf_status list_all_facing(tf_reconnector *reconnector, double distance)
{
    int corners = 3 * reconnector->surface->triangles;
    tf_watch *watch = reconnector->surface->watch;
    const tf_vector *normal = reconnector->normal.data;
    tf_watch_stage(watch, "contacts", (size_t)corners);
    for (int c = 0; c < corners; c++) {
        if (c % WATCHED == 0 && !tf_watch_done(watch, WATCHED))
            return TF_CANCELLED;
        if (tf_vector_dot(normal[c], normal[c]) > 0 &&
            !list_facing(reconnector, c, distance))
            return TF_OUT_OF_MEMORY;
    }
    return TF_OK;
}

tf_status tf_list_facing(tf_reconnector *reconnector, double distance)
{
    reconnector->candidates = 0;
    tf_status status = find_normals(reconnector);
    if (status == TF_OK)
        status = list_all_facing(reconnector, distance);
    return status == TF_OK
               ? tf_reconnector_sort(reconnector, sizeof(tf_facing_edges),
                                     is_nearer)
               : status;
}
