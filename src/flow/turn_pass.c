//: Describe a flip in a flow
#include "flow/flow_state.h"

#include "flow/patch.h"
#include "surgery/flip.h"
#include "surgery/star.h"

/// What a flip changes: the vertices a, b of the edge and c, d of the other
/// diagonal.
typedef struct turning {
    int vertex[4];
    tf_diagonals both;
    double gained; ///< volume, times 6
} turning;

static turning turning_of(const tf_adaptive_surface *surface, int forth,
                          int back)
{
    turning t = {{tf_vertex_at(surface, forth), tf_vertex_at(surface, back),
                  tf_vertex_at(surface, tf_corner_before(forth)),
                  tf_vertex_at(surface, tf_corner_before(back))},
                 tf_diagonals_of(surface, forth, back),
                 0};
    tf_patch patch = {.apex = tf_position_of(surface, t.vertex[2])};
    for (int i = 0; i < 2; i++)
        tf_patch_add(&patch, &t.both.own[i]);
    t.gained = -patch.below;
    return t;
}

//: Compare the two diagonals of a flow
static double area_of_pair(const tf_shape pair[2])
{
    return tf_vector_length(tf_shape_normal(&pair[0])) +
           tf_vector_length(tf_shape_normal(&pair[1]));
}

/// Whether the other diagonal is shorter, and the surface hardly changes.
static bool is_shorter(const tf_flow_state *flow, const turning *t,
                       double length)
{
    const tf_adaptive_surface *surface = flow->remesher.surface;
    double edge = flow->remesher.edge;
    double other = tf_length_of(surface, t->vertex[2], t->vertex[3]);
    double before = area_of_pair(t->both.own);
    double after = area_of_pair(t->both.other);
    return other < length - 1e-3 * edge &&
           fabs(t->gained) <= 6 * 0.02 * edge * edge * edge &&
           fabs(after - before) <= 0.1 * before &&
           tf_diagonals_agree(&t->both) &&
           fmin(tf_shape_quality(&t->both.other[0]),
                tf_shape_quality(&t->both.other[1])) >= 0.1;
}

//: Turn an edge to its other diagonal
static tf_status turn_edge(tf_flow_state *flow, const tf_edge_row *edge)
{
    tf_adaptive_surface *surface = flow->remesher.surface;
    int forth = tf_find_edge(surface, edge->a, edge->b);
    int back = tf_find_edge(surface, edge->b, edge->a);
    if (forth == TF_NONE || back == TF_NONE)
        return TF_OK;
    turning t = turning_of(surface, forth, back);
    if (!is_shorter(flow, &t, tf_length_of(surface, edge->a, edge->b)))
        return TF_OK;
    tf_outcome outcome;
    tf_status status = tf_adaptive_flip(surface, edge->a, edge->b, &outcome);
    if (status != TF_OK)
        return status;
    tf_remesher_count(&flow->remesher, TF_FLIP, outcome);
    return outcome == TF_COMMITTED && tf_flow_keeps_volume(flow, TF_FLIP)
               ? tf_flow_restore_volume(flow, -t.gained, 4, t.vertex)
               : TF_OK;
}

//: Turn all edges that have a shorter diagonal
tf_status tf_turn_pass(tf_flow_state *flow)
{
    tf_remesher *remesher = &flow->remesher;
    if (!tf_remesher_list(remesher, 0, INFINITY))
        return TF_OUT_OF_MEMORY;
    const tf_edge_row *row = remesher->row.data;
    tf_status status = TF_OK;
    for (int i = remesher->rows - 1; i >= 0 && status == TF_OK; i--)
        status = turn_edge(flow, &row[i]);
    return status;
}
