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
    if (is_sharp(remesher, corner))
        tf_trace_sharp_point(&remesher->trace, surface, end, position);
    else
        *position = project(remesher, *position);
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

//: Choose where a vertex is moved along a sharp edge
/// How far it has to go along an edge for both to be equally long, as parts of
/// their target lengths, as a part of that edge; negative: along the other one.
static double way_along(const tf_remesher *remesher, int vertex, int to,
                        int other)
{
    double length = tf_length_of(remesher->surface, vertex, to);
    double target = tf_target_between(remesher, vertex, to);
    double behind = tf_length_of(remesher->surface, vertex, other);
    double target_behind = tf_target_between(remesher, vertex, other);
    return (length * target_behind - behind * target) /
           ((target + target_behind) * length);
}

/// Whether sharp edges to both ends would have that length together.
static bool stay_long(const tf_adaptive_surface *surface, const int end[2],
                      tf_vector position, double least)
{
    double sum = 0;
    for (int i = 0; i < 2; i++)
        sum += tf_vector_length(
            tf_vector_difference(tf_position_of(surface, end[i]), position));
    return sum >= least;
}

static bool slide(tf_remesher *remesher, int vertex, tf_vector *position)
{
    const tf_adaptive_surface *surface = remesher->surface;
    tf_sharp_pair pair = tf_sharp_edges_along(&remesher->sharp, vertex);
    const int end[] = {pair.link[0]->to, pair.link[1]->to};
    double part[] = {way_along(remesher, vertex, end[0], end[1]),
                     way_along(remesher, vertex, end[1], end[0])};
    int longer = part[1] > part[0];
    const int between[] = {vertex, end[longer]};
    tf_vector from = tf_position_of(surface, vertex);
    tf_vector way =
        tf_vector_difference(tf_position_of(surface, end[longer]), from);
    double length = pair.link[0]->length + pair.link[1]->length;
    *position = tf_vector_sum(from, part[longer], way);
    return tf_trace_sharp_point(&remesher->trace, surface, between, position) &&
           stay_long(surface, end, *position, least_length * length);
}

//: Choose where a vertex is smoothed to
static bool move_for_shape(tf_remesher *remesher, int vertex,
                           tf_vector *position)
{
    tf_freedom freedom = tf_freedom_of(&remesher->sharp, vertex);
    if (freedom == TF_ALONG_SHARP_EDGE)
        return slide(remesher, vertex, position);
    *position = project(remesher, tf_star_middle(remesher->surface, vertex));
    return freedom == TF_FREE;
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
