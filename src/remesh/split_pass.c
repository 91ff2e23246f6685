//: Split a long edge
#include "remesh/remesher.h"

#include "remesh/crease.h"
#include "remesh/measure.h"
#include "surgery/split.h"
#include "surgery/star.h"

/// A corner where the edge begins, in either direction, or TF_NONE.
static int corner_of_edge(const tf_adaptive_surface *surface,
                          const tf_edge_row *edge)
{
    int corner = tf_find_edge(surface, edge->a, edge->b);
    return corner == TF_NONE ? tf_find_edge(surface, edge->b, edge->a) : corner;
}

/// On a crease at its middle, else where the original is nearest to that.
static tf_vector place_of_split(tf_remesher *remesher, const tf_edge_row *edge,
                                int corner)
{
    tf_vector middle = tf_middle_of(remesher->surface, edge->a, edge->b);
    return tf_is_crease(remesher->surface, corner)
               ? middle
               : tf_remesher_project(remesher, middle);
}

static tf_status split_edge(tf_remesher *remesher, const tf_edge_row *edge)
{
    int corner = corner_of_edge(remesher->surface, edge), vertex;
    if (corner == TF_NONE)
        return TF_OK;
    tf_vector place = place_of_split(remesher, edge, corner);
    tf_outcome outcome;
    tf_status status = tf_adaptive_split(remesher->surface, edge->a, edge->b,
                                         place.x, &vertex, &outcome);
    if (status == TF_OK)
        tf_remesher_count(remesher, TF_SPLIT, outcome);
    return status;
}

//: Split all long edges
tf_status tf_split_pass(tf_remesher *remesher)
{
    if (!tf_remesher_list(remesher, remesher->edge * 4 / 3, INFINITY))
        return TF_OUT_OF_MEMORY;
    const tf_edge_row *row = remesher->row.data;
    tf_status status = TF_OK;
    for (int i = remesher->rows - 1; i >= 0 && status == TF_OK; i--)
        status = split_edge(remesher, &row[i]);
    return status;
}
