//: Find out whether an edge may flip
#include "surgery/operations.h"

#include "surgery/request.h"
#include "surgery/star.h"

enum {
    FLIP_ROOM = 4 ///< for the lists of the surgery
};

/// Whether a vertex of the edge keeps enough triangles.
static bool end_survives(const tf_adaptive *of, int vertex)
{
    return tf_star_size(of, vertex) >= (tf_is_rim(of, vertex) ? 2 : 4);
}

/// The vertices opposite to the edge.
static bool may_flip(const tf_adaptive *of, int a, int b, int c, int d)
{
    return end_survives(of, a) && end_survives(of, b) &&
           tf_find_edge(of, c, d) == TF_NONE &&
           tf_find_edge(of, d, c) == TF_NONE;
}

//: Flip an edge as far as it is possible
static tf_outcome flip(tf_adaptive *of, int a, int b)
{
    int forth = tf_find_edge(of, a, b), back = tf_find_edge(of, b, a);
    if (forth == TF_NONE || back == TF_NONE)
        return TF_IMPOSSIBLE;
    int c = tf_vertex_at(of, tf_corner_before(forth));
    int d = tf_vertex_at(of, tf_corner_before(back));
    if (!may_flip(of, a, b, c, d))
        return TF_IMPOSSIBLE;
    tf_surgery_remove(of, forth / 3);
    tf_surgery_remove(of, back / 3);
    tf_surgery_add(of, c, d, b);
    tf_surgery_add(of, d, c, a);
    tf_surgery_sweep(of, a, b, c, d);
    tf_outcome outcome = tf_surgery_try(of);
    if (outcome == TF_COMMITTED)
        tf_surgery_commit(of);
    return outcome;
}

//: Flip an edge
tf_status tf_adaptive_flip(tf_adaptive *surface, int a, int b,
                           tf_outcome *outcome)
{
    tf_status status = tf_request_check(surface, a, b, NULL, outcome);
    if (status != TF_OK)
        return status;
    if (!tf_surgery_begin(surface, FLIP_ROOM))
        return TF_OUT_OF_MEMORY;
    *outcome = flip(surface, a, b);
    return TF_OK;
}
