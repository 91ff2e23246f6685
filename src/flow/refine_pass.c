//: Choose where a long edge is split
#include "flow/flow_state.h"

#include "flow/butterfly.h"
#include "flow/patch.h"
#include "surgery/split.h"
#include "surgery/star.h"

/// The butterfly point, unless it is far from the middle.
static tf_vector place_on_edge(const tf_adaptive_surface *surface, int corner,
                               double length)
{
    tf_vector point = tf_butterfly_point(surface, corner);
    tf_vector middle =
        tf_middle_of(surface, tf_vertex_at(surface, corner),
                     tf_vertex_at(surface, tf_corner_after(corner)));
    tf_vector way = tf_vector_difference(point, middle);
    return tf_vector_length(way) <= length / 4 ? point : middle;
}

//: Describe how a long edge is split
/// An edge that is split: its ends a and b and the vertices across from it, and
/// its two triangles, with the place of the new vertex as the apex.
typedef struct refining {
    int vertex[4];
    tf_patch patch;
} refining;

static refining refining_of(const tf_adaptive_surface *surface, int forth,
                            int back)
{
    refining r = {{tf_vertex_at(surface, forth), tf_vertex_at(surface, back),
                   tf_vertex_at(surface, tf_corner_before(forth)),
                   tf_vertex_at(surface, tf_corner_before(back))},
                  {{{0}}, {{0}}, 0}};
    double length = tf_length_of(surface, r.vertex[0], r.vertex[1]);
    tf_shape own = tf_shape_of(surface, forth / 3);
    tf_shape other = tf_shape_of(surface, back / 3);
    r.patch.apex = place_on_edge(surface, forth, length);
    tf_patch_add(&r.patch, &own);
    tf_patch_add(&r.patch, &other);
    return r;
}

//: Refine an edge
static tf_status try_refining(tf_flow_state *flow, int a, int b,
                              tf_vector place, tf_outcome *outcome)
{
    int vertex;
    tf_status status = tf_adaptive_split(flow->remesher.surface, a, b, place.x,
                                         &vertex, outcome);
    if (status == TF_OK)
        tf_remesher_count(&flow->remesher, TF_SPLIT, *outcome);
    return status;
}

/// At its middle, which changes nothing.
static tf_status refine_in_middle(tf_flow_state *flow, int a, int b)
{
    tf_outcome outcome;
    return try_refining(flow, a, b, tf_middle_of(flow->remesher.surface, a, b),
                        &outcome);
}

//: Refine an edge where the surface curves on
/// What is gained the vertices around give back.
static tf_status refine_edge(tf_flow_state *flow, const tf_edge_row *edge)
{
    tf_adaptive_surface *surface = flow->remesher.surface;
    int forth = tf_find_edge(surface, edge->a, edge->b);
    int back = tf_find_edge(surface, edge->b, edge->a);
    if (forth == TF_NONE || back == TF_NONE)
        return refine_in_middle(flow, edge->a, edge->b);
    refining r = refining_of(surface, forth, back);
    tf_outcome outcome;
    tf_status status =
        try_refining(flow, edge->a, edge->b, r.patch.apex, &outcome);
    if (status != TF_OK)
        return status;
    if (outcome != TF_COMMITTED)
        return refine_in_middle(flow, edge->a, edge->b);
    return tf_flow_keeps_volume(flow, TF_SPLIT)
               ? tf_flow_restore_volume(flow, r.patch.below, 4, r.vertex)
               : TF_OK;
}

//: Refine all long edges
tf_status tf_refine_pass(tf_flow_state *flow)
{
    tf_remesher *remesher = &flow->remesher;
    if (!tf_remesher_list(remesher, remesher->edge * 1.5, INFINITY))
        return TF_OUT_OF_MEMORY;
    const tf_edge_row *row = remesher->row.data;
    tf_status status = TF_OK;
    for (int i = remesher->rows - 1; i >= 0 && status == TF_OK; i--)
        status = refine_edge(flow, &row[i]);
    return status;
}
