//: Find the wings of a butterfly
#include "flow/butterfly.h"

#include "surgery/star.h"

/// The vertex across the edge of a corner, or TF_NONE.
static int vertex_across(const tf_adaptive_surface *surface, int corner)
{
    int back =
        tf_find_edge(surface, tf_vertex_at(surface, tf_corner_after(corner)),
                     tf_vertex_at(surface, corner));
    return back == TF_NONE ? TF_NONE
                           : tf_vertex_at(surface, tf_corner_before(back));
}

/// Adds what the triangle of a corner on the edge contributes; false if it or a
/// triangle next to it is missing.
static bool add_wings(const tf_adaptive_surface *surface, int corner,
                      tf_vector *sum)
{
    if (corner == TF_NONE)
        return false;
    const int wing[] = {vertex_across(surface, tf_corner_after(corner)),
                        vertex_across(surface, tf_corner_before(corner))};
    int apex = tf_vertex_at(surface, tf_corner_before(corner));
    if (wing[0] == TF_NONE || wing[1] == TF_NONE)
        return false;
    *sum = tf_vector_sum(*sum, 0.125, tf_position_of(surface, apex));
    for (int i = 0; i < 2; i++)
        *sum = tf_vector_sum(*sum, -0.0625, tf_position_of(surface, wing[i]));
    return true;
}

//: Find a butterfly point
tf_vector tf_butterfly_point(const tf_adaptive_surface *surface, int corner)
{
    int a = tf_vertex_at(surface, corner);
    int b = tf_vertex_at(surface, tf_corner_after(corner));
    tf_vector middle = tf_middle_of(surface, a, b), point = middle;
    return add_wings(surface, corner, &point) &&
                   add_wings(surface, tf_find_edge(surface, b, a), &point)
               ? point
               : middle;
}
