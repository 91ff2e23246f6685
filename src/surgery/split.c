//: Split one triangle
#include "surgery/split.h"

#include "base/require.h"
#include "surgery/request.h"
#include "surgery/star.h"
#include "surgery/surgery.h"
#include "surgery/trial.h"

enum {
    SPLIT_ROOM = 4 ///< for the lists of the surgery
};

/// Splits the triangle at whose corner the edge begins.
static void split_triangle(tf_adaptive_surface *surface, int corner, int middle)
{
    int a = tf_vertex_at(surface, corner);
    int b = tf_vertex_at(surface, tf_corner_after(corner));
    int c = tf_vertex_at(surface, tf_corner_before(corner));
    tf_surgery_remove(surface, corner / 3);
    tf_surgery_add(surface, a, middle, c);
    tf_surgery_add(surface, middle, b, c);
    tf_surgery_sweep(surface, a, b, c, middle);
    tf_surgery_keep(surface, tf_corner_after(corner));
    tf_surgery_keep(surface, tf_corner_before(corner));
}

//: Describe a split
/// The corners where the edge begins, in each direction.
static tf_outcome try_split(tf_adaptive_surface *surface, const int corner[2],
                            const double position[3], int *vertex)
{
    for (int i = 0; i < 2; i++)
        if (corner[i] != TF_NONE && tf_is_isolated(surface, corner[i] / 3))
            return TF_IMPOSSIBLE;
    *vertex = tf_surgery_place(surface, position);
    for (int i = 0; i < 2; i++)
        if (corner[i] != TF_NONE)
            split_triangle(surface, corner[i], *vertex);
    return tf_surgery_try(surface);
}

//: Split an edge
tf_status tf_adaptive_split(tf_adaptive_surface *surface, int a, int b,
                            const double position[3], int *vertex,
                            tf_outcome *outcome)
{
    TF_REQUIRE(position && vertex);
    tf_status status = tf_request_check(surface, a, b, position, outcome);
    if (status != TF_OK)
        return status;
    int corner[] = {tf_find_edge(surface, a, b), tf_find_edge(surface, b, a)};
    int middle = TF_NONE;
    *outcome = TF_IMPOSSIBLE;
    if ((corner[0] == TF_NONE && corner[1] == TF_NONE) ||
        tf_is_frozen_edge(surface, a, b))
        return TF_OK;
    if (!tf_surgery_begin(surface, SPLIT_ROOM)) {
        *outcome = TF_NO_OUTCOME;
        return TF_OUT_OF_MEMORY;
    }
    *outcome = try_split(surface, corner, position, &middle);
    if (*outcome != TF_COMMITTED)
        return TF_OK;
    tf_surgery_accept(surface);
    tf_surgery_commit(surface);
    *vertex = middle;
    return TF_OK;
}
