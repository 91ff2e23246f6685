//: Include what the passes need
#include "remesh/passes.h"

#include "remesh/policy.h"
#include "surgery/collapse.h"
#include "surgery/flip.h"
#include "surgery/move.h"
#include "surgery/split.h"
#include "surgery/star.h"

//: Trace what is placed
/// Where a vertex comes from that has been put between two, or moved.
static tf_status trace(tf_remesher *remesher, int vertex, int a, int b,
                       bool sharp)
{
    tf_placement placed = {vertex, {a, b}, sharp, &remesher->projection};
    return tf_trace_place(&remesher->trace, remesher->surface, &placed)
               ? TF_OK
               : TF_OUT_OF_MEMORY;
}

//: Hand on what is sharp
static tf_status split_sharp(tf_remesher *remesher, const tf_edge_row *edge,
                             int vertex, bool sharp)
{
    tf_sharp_edges *all = &remesher->sharp;
    bool good = tf_sharp_edges_extend(all, remesher->surface->vertices) &&
                (!sharp || tf_sharp_edges_split(all, edge->a, edge->b, vertex));
    if (good && sharp)
        tf_sharp_edges_slide(all, remesher->surface, vertex);
    return good ? TF_OK : TF_OUT_OF_MEMORY;
}

//: Try a split
static tf_status try_split(tf_remesher *remesher, const tf_edge_row *edge,
                           tf_vector position, bool sharp, tf_outcome *outcome)
{
    int vertex;
    tf_vector at = tf_coordinates_of(remesher->surface, position);
    tf_status status = tf_adaptive_split(remesher->surface, edge->a, edge->b,
                                         at.x, &vertex, outcome);
    if (status != TF_OK)
        return status;
    tf_remesher_count(remesher, TF_SPLIT, *outcome);
    if (*outcome != TF_COMMITTED)
        return TF_OK;
    status = split_sharp(remesher, edge, vertex, sharp);
    return status == TF_OK ? trace(remesher, vertex, edge->a, edge->b, sharp)
                           : status;
}

//: Wait for a longer edge
/// How much longer the edges of a triangle may be than one that is split.
static const double most_ratio = 1.5;

/// Whether a triangle on an edge has one that is so much longer.  Usually that
/// one is split first.  If it is left alone, though, splits beside it would make
/// ever flatter triangles, and never end.
static bool has_longer_beside(const tf_adaptive_surface *surface,
                              const tf_edge_row *edge)
{
    const int end[] = {edge->a, edge->b};
    double most = most_ratio * tf_length_of(surface, edge->a, edge->b);
    for (int i = 0; i < 2; i++) {
        int corner = tf_find_edge(surface, end[i], end[1 - i]);
        if (corner == TF_NONE)
            continue;
        int apex = tf_vertex_at(surface, tf_corner_before(corner));
        if (tf_length_of(surface, end[0], apex) > most ||
            tf_length_of(surface, end[1], apex) > most)
            return true;
    }
    return false;
}

//: Split a long edge
/// At the first position that is not refused.
static tf_status split_edge(tf_remesher *remesher, const tf_edge_row *edge)
{
    const tf_remesh_policy *policy = remesher->policy;
    int corner = tf_find_edge(remesher->surface, edge->a, edge->b);
    bool sharp = tf_find_sharp_edge(&remesher->sharp, edge->a, edge->b);
    tf_vector position;
    tf_volume_error error = {0};
    tf_outcome outcome = TF_NO_OUTCOME;
    tf_status status = TF_OK;
    if (remesher->surface->marked > 0 &&
        has_longer_beside(remesher->surface, edge))
        return TF_OK;
    for (int refused = 0;
         status == TF_OK && outcome != TF_COMMITTED &&
         policy->choose_split(remesher, corner, refused, &position, &error);
         refused++)
        status = try_split(remesher, edge, position, sharp, &outcome);
    return status == TF_OK && outcome == TF_COMMITTED && policy->restore
               ? policy->restore(remesher, &error)
               : status;
}

//: Find out whether edges stay short
/// Whether no edge would be longer than `most` that leads from a vertex to
/// another one than `other`, if it were at a position.
static bool edges_stay_short(const tf_adaptive_surface *surface, int vertex,
                             int other, tf_vector position, double most)
{
    int c = tf_first_corner(surface, vertex);
    for (; c != TF_NONE; c = tf_next_corner(surface, c))
        for (int i = 1; i < 3; i++) {
            int end = tf_vertex_at(surface, c / 3 * 3 + (c + i) % 3);
            tf_vector way =
                tf_vector_difference(tf_position_of(surface, end), position);
            if (end != other && tf_vector_length(way) > most)
                return false;
        }
    return true;
}

//: Find out whether a collapse makes good triangles
/// Not those of a vertex that is left alone, which stays where it is.
static bool is_good(const tf_remesher *remesher,
                    const tf_edge_collapse *collapse)
{
    const tf_adaptive_surface *surface = remesher->surface;
    int from = collapse->from, to = collapse->to;
    tf_vector position = collapse->position;
    double most = tf_fraction_of(tf_target_between(remesher, from, to),
                                 remesher->policy->longest);
    return edges_stay_short(surface, from, to, position, most) &&
           tf_star_stays_good(surface, from, to, position) &&
           (tf_is_frozen(surface, to) ||
            (edges_stay_short(surface, to, from, position, most) &&
             tf_star_stays_good(surface, to, from, position)));
}

//: Collapse an edge to where it is wanted
static tf_status collapse(tf_remesher *remesher, const tf_edge_collapse *wanted)
{
    int from = wanted->from, to = wanted->to;
    tf_vector before = tf_position_of(remesher->surface, to);
    bool moved = !tf_vector_equals(before, wanted->position);
    tf_vector at =
        moved ? tf_coordinates_of(remesher->surface, wanted->position)
              : tf_vector_at(tf_vertex_coordinates(remesher->surface, to), 0);
    tf_outcome outcome;
    tf_status status =
        tf_adaptive_collapse_to(remesher->surface, from, to, at.x, &outcome);
    if (status != TF_OK)
        return status;
    tf_remesher_count(remesher, TF_COLLAPSE, outcome);
    if (outcome != TF_COMMITTED)
        return TF_OK;
    tf_sharp_edges_collapse(&remesher->sharp, from, to);
    return moved ? trace(remesher, to, from, to, false) : TF_OK;
}

//: Collapse a short edge
/// The length of an edge by now, as a multiple of the target length.
static double ratio_of(const tf_remesher *remesher, const tf_edge_row *edge)
{
    return tf_length_of(remesher->surface, edge->a, edge->b) /
           tf_target_between(remesher, edge->a, edge->b);
}

static tf_status collapse_edge(tf_remesher *remesher, const tf_edge_row *edge)
{
    const tf_adaptive_surface *surface = remesher->surface;
    int corner = tf_find_edge(surface, edge->a, edge->b);
    tf_edge_collapse wanted;
    if (corner == TF_NONE || ratio_of(remesher, edge) > edge->ratio ||
        !remesher->policy->choose_collapse(remesher, corner, &wanted) ||
        !is_good(remesher, &wanted))
        return TF_OK;
    return collapse(remesher, &wanted);
}

//: Collect the diagonals
static tf_diagonals diagonals_of(const tf_adaptive_surface *surface, int forth,
                                 int back)
{
    int v[] = {tf_vertex_at(surface, forth), tf_vertex_at(surface, back),
               tf_vertex_at(surface, tf_corner_before(forth)),
               tf_vertex_at(surface, tf_corner_before(back))};
    tf_vector a = tf_position_of(surface, v[0]);
    tf_vector b = tf_position_of(surface, v[1]);
    tf_vector c = tf_position_of(surface, v[2]);
    tf_vector d = tf_position_of(surface, v[3]);
    return (tf_diagonals){.corner = forth,
                          .vertex = {v[0], v[1], v[2], v[3]},
                          .own = {{{a, b, c}}, {{b, a, d}}},
                          .other = {{{c, d, b}}, {{d, c, a}}}};
}

//: Find out whether a flip bends the surface
/// Whether it does so by little.
static bool diagonals_agree(const tf_diagonals *diagonals)
{
    tf_vector normal = tf_vector_sum(tf_shape_normal(&diagonals->own[0]), 1,
                                     tf_shape_normal(&diagonals->own[1]));
    for (int i = 0; i < 2; i++)
        if (!tf_normals_agree(tf_shape_normal(&diagonals->other[i]), normal,
                              0.9))
            return false;
    return true;
}

//: Flip an edge if it is wanted
static tf_status flip_edge(tf_remesher *remesher, const tf_edge_row *edge)
{
    const tf_remesh_policy *policy = remesher->policy;
    tf_adaptive_surface *surface = remesher->surface;
    int forth = tf_find_edge(surface, edge->a, edge->b);
    int back = tf_find_edge(surface, edge->b, edge->a);
    if (forth == TF_NONE || back == TF_NONE)
        return TF_OK;
    tf_diagonals both = diagonals_of(surface, forth, back);
    tf_volume_error error = {0};
    if (!policy->choose_flip(remesher, &both, &error) ||
        !diagonals_agree(&both))
        return TF_OK;
    tf_outcome outcome;
    tf_status status = tf_adaptive_flip(surface, edge->a, edge->b, &outcome);
    if (status == TF_OK)
        tf_remesher_count(remesher, TF_FLIP, outcome);
    return outcome == TF_COMMITTED && policy->restore
               ? policy->restore(remesher, &error)
               : status;
}

//: Smooth a vertex
/// Whether a position is far enough from a vertex to be worth a move.
static bool is_worth_a_move(const tf_remesher *remesher, int vertex,
                            tf_vector position)
{
    tf_vector way = tf_vector_difference(
        position, tf_position_of(remesher->surface, vertex));
    return tf_vector_length(way) > tf_target_at(remesher, vertex) / 20;
}

static tf_status smooth_vertex(tf_remesher *remesher, int vertex)
{
    tf_vector position;
    if (!remesher->policy->choose_move(remesher, vertex, &position) ||
        !is_worth_a_move(remesher, vertex, position) ||
        !tf_star_stays_good(remesher->surface, vertex, TF_NONE, position))
        return TF_OK;
    tf_vector at = tf_coordinates_of(remesher->surface, position);
    tf_outcome outcome;
    tf_status status =
        tf_adaptive_move(remesher->surface, vertex, at.x, &outcome);
    if (status != TF_OK)
        return status;
    tf_remesher_count(remesher, TF_SMOOTH, outcome);
    if (outcome != TF_COMMITTED)
        return TF_OK;
    bool sharp = tf_freedom_of(&remesher->sharp, vertex) != TF_FREE;
    if (sharp)
        tf_sharp_edges_slide(&remesher->sharp, remesher->surface, vertex);
    return trace(remesher, vertex, vertex, vertex, sharp);
}

//: Smooth all vertices
enum {
    WATCHED = 8 ///< vertices that are smoothed before the caller is told
};

static tf_status smooth_all(tf_remesher *remesher)
{
    const tf_adaptive_surface *surface = remesher->surface;
    tf_status status = TF_OK;
    tf_watch_stage(surface->watch, "smoothing", (size_t)surface->vertices);
    for (int v = 0; v < surface->vertices && status == TF_OK; v++) {
        if (v % WATCHED == 0 && !tf_watch_done(surface->watch, WATCHED))
            return TF_CANCELLED;
        if (tf_first_corner(surface, v) != TF_NONE)
            status = smooth_vertex(remesher, v);
    }
    return status;
}

//: Go once through a surface
tf_status tf_remesh_pass(tf_remesher *remesher, tf_operation operation)
{
    static const tf_edge_pass passes[] = {
        [TF_SPLIT] = {"splitting", TF_LONGEST_FIRST, split_edge},
        [TF_COLLAPSE] = {"collapsing", TF_SHORTEST_FIRST, collapse_edge},
        [TF_FLIP] = {"flipping", TF_LONGEST_FIRST, flip_edge}};
    const tf_remesh_policy *policy = remesher->policy;
    double longest = tf_fraction_of(1, policy->longest);
    double shortest = tf_fraction_of(1, policy->shortest);
    switch (operation) {
    case TF_SPLIT:
        return tf_remesher_visit(remesher, &passes[TF_SPLIT], longest,
                                 INFINITY);
    case TF_COLLAPSE:
        return tf_remesher_visit(remesher, &passes[TF_COLLAPSE], 0, shortest);
    case TF_FLIP:
        return tf_remesher_visit(remesher, &passes[TF_FLIP], 0, INFINITY);
    default:
        return smooth_all(remesher);
    }
}

//: Go through all passes
/// Repeats a pass until it does nothing, or for the last time.
static tf_status repeat_pass(tf_remesher *remesher, tf_operation operation,
                             int most)
{
    const size_t *done = &remesher->report.tried[operation][TF_COMMITTED];
    tf_status status = TF_OK;
    size_t before = *done - 1;
    for (int i = 0; i < most && status == TF_OK && *done != before; i++) {
        before = *done;
        status = tf_remesh_pass(remesher, operation);
    }
    return status;
}

tf_status tf_remesh_round(tf_remesher *remesher)
{
    tf_status status = TF_OK;
    for (int i = 0; i < TF_REMESH_PASSES && status == TF_OK; i++)
        status = repeat_pass(remesher, remesher->policy->pass[i].operation,
                             remesher->policy->pass[i].most);
    return status;
}
