//: Split a long edge
#include "remesh/remesher.h"

#include "remesh/crease.h"
#include "remesh/measure.h"
#include "surgery/operations.h"
#include "surgery/star.h"

/// A corner where the edge begins, in either direction, or TF_NONE.
static int corner_of_edge(const tf_adaptive *of, const tf_edge_row *edge)
{
    int corner = tf_find_edge(of, edge->a, edge->b);
    return corner == TF_NONE ? tf_find_edge(of, edge->b, edge->a) : corner;
}

/// On a crease at its middle, else where the original is nearest to that.
static tf_vector place_of_split(tf_remesher *of, const tf_edge_row *edge,
                                int corner)
{
    tf_vector middle = tf_middle_of(of->of, edge->a, edge->b);
    return tf_is_crease(of->of, corner) ? middle
                                        : tf_remesher_project(of, middle);
}

static tf_status split_edge(tf_remesher *of, const tf_edge_row *edge)
{
    int corner = corner_of_edge(of->of, edge), vertex;
    if (corner == TF_NONE)
        return TF_OK;
    tf_vector place = place_of_split(of, edge, corner);
    tf_outcome outcome;
    tf_status status =
        tf_adaptive_split(of->of, edge->a, edge->b, place.x, &vertex, &outcome);
    if (status == TF_OK)
        tf_remesher_count(of, TF_SPLIT, outcome);
    return status;
}

//: Split all long edges
tf_status tf_split_pass(tf_remesher *of)
{
    if (!tf_remesher_list(of, of->edge * 4 / 3, INFINITY))
        return TF_OUT_OF_MEMORY;
    const tf_edge_row *row = of->row.data;
    tf_status status = TF_OK;
    for (int i = of->rows - 1; i >= 0 && status == TF_OK; i--)
        status = split_edge(of, &row[i]);
    return status;
}
