//: Include what keeps the volume
#include "flow/keep_volume.h"

#include "flow/butterfly.h"
#include "flow/patch.h"
#include "surgery/move.h"
#include "surgery/star.h"

//: Choose between the butterfly point and the middle
/// The butterfly point, unless it is far from the middle.
static tf_vector butterfly_or_middle(const tf_adaptive_surface *surface,
                                     int corner, tf_vector middle)
{
    int a = tf_vertex_at(surface, corner);
    int b = tf_vertex_at(surface, tf_corner_after(corner));
    tf_vector point = tf_butterfly_point(surface, corner);
    tf_vector way = tf_vector_difference(point, middle);
    bool is_near = tf_vector_length(way) <= tf_length_of(surface, a, b) / 4;
    return is_near ? point : middle;
}

//: Collect the patch of an edge
/// The two triangles on an edge, with the new vertex as the apex.
static tf_patch patch_of_edge(const tf_adaptive_surface *surface, int forth,
                              int back, tf_vector apex)
{
    tf_patch patch = {.apex = apex};
    tf_shape own = tf_shape_of(surface, forth / 3);
    tf_shape other = tf_shape_of(surface, back / 3);
    tf_patch_add(&patch, &own);
    tf_patch_add(&patch, &other);
    return patch;
}

//: Choose where an edge is split in a flow
/// At the butterfly point; on the boundary, or if that was refused, in the
/// middle, where nothing is lost.
static bool split_for_volume(tf_remesher *remesher, int forth, int refused,
                             tf_vector *position, tf_volume_error *error)
{
    const tf_adaptive_surface *surface = remesher->surface;
    int a = tf_vertex_at(surface, forth);
    int b = tf_vertex_at(surface, tf_corner_after(forth));
    int back = tf_find_edge(surface, b, a), inside = back != TF_NONE;
    *position = tf_middle_of(surface, a, b);
    *error = (tf_volume_error){0};
    if (refused >= inside)
        return refused == inside;
    *position = butterfly_or_middle(surface, forth, *position);
    *error = (tf_volume_error){
        .lost = patch_of_edge(surface, forth, back, *position).below,
        .count = 4,
        .vertex = {a, b, tf_vertex_at(surface, tf_corner_before(forth)),
                   tf_vertex_at(surface, tf_corner_before(back))}};
    return true;
}

//: Choose which edges flip in a flow
static double area_of_pair(const tf_shape pair[2])
{
    return tf_vector_length(tf_shape_normal(&pair[0])) +
           tf_vector_length(tf_shape_normal(&pair[1]));
}

/// Those whose other diagonal is shorter, if the surface hardly changes.
static bool flip_for_volume(tf_remesher *remesher, const tf_diagonals *both,
                            tf_volume_error *error)
{
    const tf_adaptive_surface *surface = remesher->surface;
    const int *v = both->vertex;
    double edge = remesher->edge;
    if (!(tf_length_of(surface, v[2], v[3]) <
          tf_length_of(surface, v[0], v[1]) - 1e-3 * edge))
        return false;
    double before = area_of_pair(both->own), after = area_of_pair(both->other);
    tf_patch patch = {.apex = tf_position_of(surface, v[2])};
    for (int i = 0; i < 2; i++)
        tf_patch_add(&patch, &both->own[i]);
    *error = (tf_volume_error){patch.below, 4, {v[0], v[1], v[2], v[3]}};
    return fabs(patch.below) <= 6 * 0.02 * edge * edge * edge &&
           fabs(after - before) <= 0.1 * before &&
           tf_worse_quality(both->other) >= 0.1;
}

//: Collect the patch of a collapse
/// The triangles at both ends of an edge, each once.
static tf_patch patch_of_stars(const tf_adaptive_surface *surface, int a, int b,
                               tf_vector apex)
{
    tf_patch patch = tf_patch_of_star(surface, a, apex);
    int c = tf_first_corner(surface, b);
    for (; c != TF_NONE; c = tf_next_corner(surface, c)) {
        const int *vertex = tf_triangle(surface, c / 3);
        tf_shape shape = tf_shape_of(surface, c / 3);
        if (vertex[0] != a && vertex[1] != a && vertex[2] != a)
            tf_patch_add(&patch, &shape);
    }
    return patch;
}

//: Choose the position of a collapse
/// False if the volume cannot be kept nearby.
static bool choose_inside(const tf_remesher *remesher, int corner,
                          tf_edge_collapse *collapse)
{
    const tf_adaptive_surface *surface = remesher->surface;
    int from = tf_vertex_at(surface, corner);
    int to = tf_vertex_at(surface, tf_corner_after(corner));
    tf_vector point = tf_butterfly_point(surface, corner);
    tf_patch patch = patch_of_stars(surface, from, to, point);
    *collapse = (tf_edge_collapse){from, to, tf_patch_position(&patch, 0)};
    tf_vector shift = tf_vector_difference(collapse->position, point);
    return tf_vector_length(shift) <= 0.3 * remesher->edge;
}

//: Choose how the boundary collapses
/// A vertex inside goes to one on the boundary, and of two on the boundary the
/// freer one goes to the other.
static bool collapse_for_volume(tf_remesher *remesher, int corner,
                                tf_edge_collapse *collapse)
{
    const tf_adaptive_surface *surface = remesher->surface;
    const tf_sharp_edges *sharp = &remesher->sharp;
    int after = tf_corner_after(corner);
    bool inside =
        tf_freedom_of(sharp, tf_vertex_at(surface, corner)) == TF_FREE &&
        tf_freedom_of(sharp, tf_vertex_at(surface, after)) == TF_FREE;
    return inside ? choose_inside(remesher, corner, collapse)
                  : tf_collapse_freer(surface, sharp, corner, 0, collapse);
}

//: Find out whether a star is smooth
/// Whether the normals at a vertex differ so little that it is on no feature:
/// whether the mean square of their sines to the mean normal is small.
static bool is_smooth(const tf_adaptive_surface *surface, int vertex)
{
    tf_vector mean =
        tf_patch_of_star(surface, vertex, tf_position_of(surface, vertex))
            .normal;
    double along = 0, all = 0, square = tf_vector_dot(mean, mean);
    int c = tf_first_corner(surface, vertex);
    for (; c != TF_NONE; c = tf_next_corner(surface, c)) {
        tf_shape shape = tf_shape_of(surface, c / 3);
        tf_vector normal = tf_shape_normal(&shape);
        double area = tf_vector_length(normal);
        double cosine = tf_vector_dot(normal, mean);
        along += cosine * cosine / (area * square);
        all += area;
    }
    return all - along <= 0.1 * along;
}

//: Choose where a vertex is smoothed to in a flow
/// Near the middle of its star, on the level.
static bool move_for_volume(tf_remesher *remesher, int vertex,
                            tf_vector *position)
{
    const tf_adaptive_surface *surface = remesher->surface;
    if (tf_is_boundary_vertex(surface, vertex) || !is_smooth(surface, vertex))
        return false;
    tf_patch star =
        tf_patch_of_star(surface, vertex, tf_star_middle(surface, vertex));
    *position = tf_patch_position(&star, 0);
    return true;
}

//: Find where volume is restored
/// Where a vertex gains 1/6 of `more`; false if that is too far away.
static bool find_position(const tf_remesher *remesher, int vertex, double more,
                          tf_vector *position)
{
    tf_vector from = tf_position_of(remesher->surface, vertex);
    tf_patch star = tf_patch_of_star(remesher->surface, vertex, from);
    *position = tf_patch_position(&star, more);
    tf_vector way = tf_vector_difference(*position, from);
    return tf_vector_length(way) <= 0.1 * remesher->edge;
}

//: Restore volume
/// Moves the vertices of a volume error along their normals, one after the
/// other, such that what is lost is gained; less if a move is refused or would
/// go too far.
static tf_status restore_volume(tf_remesher *remesher,
                                const tf_volume_error *error)
{
    double lost = error->lost;
    tf_status status = TF_OK;
    for (int i = 0; i < error->count && status == TF_OK; i++) {
        double share = lost / (error->count - i);
        int vertex = error->vertex[i];
        tf_vector position;
        tf_outcome outcome;
        if (!find_position(remesher, vertex, share, &position))
            continue;
        position = tf_coordinates_of(remesher->surface, position);
        status =
            tf_adaptive_move(remesher->surface, vertex, position.x, &outcome);
        if (status != TF_OK)
            return status;
        remesher->restored[outcome]++;
        if (outcome == TF_COMMITTED)
            lost -= share;
    }
    return status;
}

//: Keep the volume
const tf_remesh_policy tf_keep_volume = {
    .longest = {3, 2},
    .shortest = {1, 2},
    .pass = {{TF_SPLIT, 3}, {TF_FLIP, 3}, {TF_COLLAPSE, 1}, {TF_SMOOTH, 1}},
    .choose_split = split_for_volume,
    .choose_collapse = collapse_for_volume,
    .choose_flip = flip_for_volume,
    .choose_move = move_for_volume,
    .restore = restore_volume,
};
