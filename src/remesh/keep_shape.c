//: Project to the original
#include "remesh/keep_shape.h"

/// The nearest point of the original if that is nearer than the target length,
/// or else the point itself.
static tf_vector project(tf_remesher *remesher, tf_vector point)
{
    tf_projection *found = &remesher->projection;
    *found = tf_original_project(&remesher->original, point);
    return found->distance < remesher->edge ? found->point : point;
}

//: Find out whether an edge is sharp
static bool is_sharp(const tf_remesher *remesher, int corner)
{
    const tf_adaptive_surface *surface = remesher->surface;
    int a = tf_vertex_at(surface, corner);
    int b = tf_vertex_at(surface, tf_corner_after(corner));
    return tf_find_sharp_edge(&remesher->sharp, a, b);
}

//: Choose where an edge is split
/// Where the original is nearest to its middle, or its sharp edges if it is
/// sharp.
static bool split_for_shape(tf_remesher *remesher, int corner, int refused,
                            tf_vector *position, tf_volume_error *error)
{
    const tf_adaptive_surface *surface = remesher->surface;
    (void)error;
    if (refused > 0)
        return false;
    const int end[] = {tf_vertex_at(surface, corner),
                       tf_vertex_at(surface, tf_corner_after(corner))};
    *position = tf_middle_of(surface, end[0], end[1]);
    *position =
        is_sharp(remesher, corner)
            ? tf_trace_sharp_point(&remesher->trace, surface, end, *position)
            : project(remesher, *position);
    return true;
}

//: Choose how a short edge collapses
/// How much of the original's sharp edges is left, at least.
static const double least_length = 0.999;

/// Two free vertices meet in the middle, and else the freer one goes to the
/// other.
static bool collapse_for_shape(tf_remesher *remesher, int corner,
                               tf_edge_collapse *collapse)
{
    const tf_adaptive_surface *surface = remesher->surface;
    int a = tf_vertex_at(surface, corner);
    int b = tf_vertex_at(surface, tf_corner_after(corner));
    const tf_sharp_edges *sharp = &remesher->sharp;
    bool may_go =
        tf_collapse_freer(surface, sharp, corner, least_length, collapse);
    if (tf_freedom_of(sharp, a) == TF_FREE &&
        tf_freedom_of(sharp, b) == TF_FREE)
        collapse->position = project(remesher, tf_middle_of(surface, a, b));
    return may_go;
}

//: Choose which edges flip
/// Those whose worse triangle becomes better.
static bool flip_for_shape(tf_remesher *remesher, const tf_diagonals *both,
                           tf_volume_error *error)
{
    (void)error;
    return !is_sharp(remesher, both->corner) &&
           tf_worse_quality(both->other) > 1.02 * tf_worse_quality(both->own);
}

//: Choose where a vertex is smoothed to
static bool move_for_shape(tf_remesher *remesher, int vertex,
                           tf_vector *position)
{
    if (tf_freedom_of(&remesher->sharp, vertex) != TF_FREE)
        return false;
    *position = project(remesher, tf_star_middle(remesher->surface, vertex));
    return true;
}

//: Keep the shape
const tf_remesh_policy tf_keep_shape = {
    .longest = {4, 3},
    .shortest = {4, 5},
    .pass = {{TF_SPLIT, 12}, {TF_COLLAPSE, 1}, {TF_FLIP, 1}, {TF_SMOOTH, 1}},
    .choose_split = split_for_shape,
    .choose_collapse = collapse_for_shape,
    .choose_flip = flip_for_shape,
    .choose_move = move_for_shape,
};
