//: Compare the diagonals
#include "remesh/remesher.h"

#include "remesh/crease.h"
#include "remesh/measure.h"
#include "surgery/flip.h"
#include "surgery/star.h"

tf_diagonals tf_diagonals_of(const tf_adaptive_surface *surface, int forth,
                             int back)
{
    tf_vector a = tf_position_of(surface, tf_vertex_at(surface, forth));
    tf_vector b = tf_position_of(surface, tf_vertex_at(surface, back));
    tf_vector c =
        tf_position_of(surface, tf_vertex_at(surface, tf_corner_before(forth)));
    tf_vector d =
        tf_position_of(surface, tf_vertex_at(surface, tf_corner_before(back)));
    return (tf_diagonals){.own = {{{a, b, c}}, {{b, a, d}}},
                          .other = {{{c, d, b}}, {{d, c, a}}}};
}

static double worse_of(const tf_shape pair[2])
{
    return fmin(tf_shape_quality(&pair[0]), tf_shape_quality(&pair[1]));
}

//: Find out whether a flip is wanted
bool tf_diagonals_agree(const tf_diagonals *diagonals)
{
    tf_vector normal = tf_vector_sum(tf_shape_normal(&diagonals->own[0]), 1,
                                     tf_shape_normal(&diagonals->own[1]));
    for (int i = 0; i < 2; i++)
        if (!tf_normals_agree(tf_shape_normal(&diagonals->other[i]), normal,
                              0.9))
            return false;
    return true;
}

/// Whether it improves the worse triangle, and bends the surface little.
static bool is_better(const tf_diagonals *diagonals)
{
    return tf_diagonals_agree(diagonals) &&
           worse_of(diagonals->other) > 1.02 * worse_of(diagonals->own);
}

//: Flip an edge if it is wanted
static tf_status flip_edge(tf_remesher *remesher, const tf_edge_row *edge)
{
    int forth = tf_find_edge(remesher->surface, edge->a, edge->b);
    int back = tf_find_edge(remesher->surface, edge->b, edge->a);
    if (forth == TF_NONE || back == TF_NONE ||
        tf_is_crease(remesher->surface, forth))
        return TF_OK;
    tf_diagonals both = tf_diagonals_of(remesher->surface, forth, back);
    if (!is_better(&both))
        return TF_OK;
    tf_outcome outcome;
    tf_status status =
        tf_adaptive_flip(remesher->surface, edge->a, edge->b, &outcome);
    if (status == TF_OK)
        tf_remesher_count(remesher, TF_FLIP, outcome);
    return status;
}

//: Flip all edges that are wanted
tf_status tf_flip_pass(tf_remesher *remesher)
{
    if (!tf_remesher_list(remesher, 0, INFINITY))
        return TF_OUT_OF_MEMORY;
    const tf_edge_row *row = remesher->row.data;
    tf_status status = TF_OK;
    for (int i = remesher->rows - 1; i >= 0 && status == TF_OK; i--)
        status = flip_edge(remesher, &row[i]);
    return status;
}
