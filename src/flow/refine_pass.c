//: Choose where a long edge is split
#include "flow/flowing.h"

#include "flow/butterfly.h"
#include "flow/patch.h"
#include "surgery/operations.h"
#include "surgery/star.h"

/// The butterfly point, unless it is far from the middle.
static tf_vector place_on_edge(const tf_adaptive *of, int corner, double length)
{
    tf_vector point = tf_butterfly_point(of, corner);
    tf_vector middle = tf_middle_of(of, tf_vertex_at(of, corner),
                                    tf_vertex_at(of, tf_corner_after(corner)));
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

static refining refining_of(const tf_adaptive *of, int forth, int back)
{
    refining r = {{tf_vertex_at(of, forth), tf_vertex_at(of, back),
                   tf_vertex_at(of, tf_corner_before(forth)),
                   tf_vertex_at(of, tf_corner_before(back))},
                  {{{0}}, {{0}}, 0}};
    double length = tf_length_of(of, r.vertex[0], r.vertex[1]);
    tf_shape own = tf_shape_of(of, forth / 3);
    tf_shape other = tf_shape_of(of, back / 3);
    r.patch.apex = place_on_edge(of, forth, length);
    tf_patch_add(&r.patch, &own);
    tf_patch_add(&r.patch, &other);
    return r;
}

//: Refine an edge
static tf_status try_refining(tf_flowing *of, int a, int b, tf_vector place,
                              tf_outcome *outcome)
{
    int vertex;
    tf_status status =
        tf_adaptive_split(of->remesher.of, a, b, place.x, &vertex, outcome);
    if (status == TF_OK)
        tf_remesher_count(&of->remesher, TF_SPLIT, *outcome);
    return status;
}

/// At its middle, which changes nothing.
static tf_status refine_in_middle(tf_flowing *of, int a, int b)
{
    tf_outcome outcome;
    return try_refining(of, a, b, tf_middle_of(of->remesher.of, a, b),
                        &outcome);
}

//: Refine an edge where the surface curves on
/// What is gained the vertices around give back.
static tf_status refine_edge(tf_flowing *of, const tf_edge_row *edge)
{
    tf_adaptive *surface = of->remesher.of;
    int forth = tf_find_edge(surface, edge->a, edge->b);
    int back = tf_find_edge(surface, edge->b, edge->a);
    if (forth == TF_NONE || back == TF_NONE)
        return refine_in_middle(of, edge->a, edge->b);
    refining r = refining_of(surface, forth, back);
    tf_outcome outcome;
    tf_status status =
        try_refining(of, edge->a, edge->b, r.patch.apex, &outcome);
    if (status != TF_OK)
        return status;
    if (outcome != TF_COMMITTED)
        return refine_in_middle(of, edge->a, edge->b);
    return tf_flowing_keeps(of, TF_SPLIT)
               ? tf_flowing_give(of, r.patch.below, 4, r.vertex)
               : TF_OK;
}

//: Refine all long edges
tf_status tf_refine_pass(tf_flowing *of)
{
    tf_remesher *remesher = &of->remesher;
    if (!tf_remesher_list(remesher, remesher->edge * 1.5, INFINITY))
        return TF_OUT_OF_MEMORY;
    const tf_edge_row *row = remesher->row.data;
    tf_status status = TF_OK;
    for (int i = remesher->rows - 1; i >= 0 && status == TF_OK; i--)
        status = refine_edge(of, &row[i]);
    return status;
}
