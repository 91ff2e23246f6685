//: Find out whether an edge may flip
#include "surgery/flip.h"

#include "surgery/request.h"
#include "surgery/star.h"
#include "surgery/surgery.h"
#include "surgery/trial.h"

enum {
    FLIP_ROOM = 4 ///< for the lists of the surgery
};

/// Whether a vertex of the edge keeps enough triangles.
static bool end_survives(const tf_adaptive_surface *surface, int vertex)
{
    return tf_star_size(surface, vertex) >=
           (tf_is_boundary_vertex(surface, vertex) ? 2 : 4);
}

/// The vertices opposite to the edge.
static bool may_flip(const tf_adaptive_surface *surface, int a, int b, int c,
                     int d)
{
    return end_survives(surface, a) && end_survives(surface, b) &&
           tf_find_edge(surface, c, d) == TF_NONE &&
           tf_find_edge(surface, d, c) == TF_NONE;
}

//: Flip an edge as far as it is possible
static tf_outcome flip(tf_adaptive_surface *surface, int a, int b)
{
    int forth = tf_find_edge(surface, a, b), back = tf_find_edge(surface, b, a);
    if (forth == TF_NONE || back == TF_NONE || tf_is_frozen_edge(surface, a, b))
        return TF_IMPOSSIBLE;
    int c = tf_vertex_at(surface, tf_corner_before(forth));
    int d = tf_vertex_at(surface, tf_corner_before(back));
    if (!may_flip(surface, a, b, c, d))
        return TF_IMPOSSIBLE;
    tf_surgery_remove(surface, forth / 3);
    tf_surgery_remove(surface, back / 3);
    tf_surgery_add(surface, c, d, b);
    tf_surgery_add(surface, d, c, a);
    tf_surgery_sweep(surface, a, b, c, d);
    tf_outcome outcome = tf_surgery_try(surface);
    if (outcome == TF_COMMITTED)
        tf_surgery_commit(surface);
    return outcome;
}

//: Flip an edge
tf_status tf_adaptive_flip(tf_adaptive_surface *surface, int a, int b,
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
