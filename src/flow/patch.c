//: Add to a patch
#include "flow/patch.h"

void tf_patch_add(tf_patch *patch, const tf_shape *shape)
{
    tf_vector normal = tf_shape_normal(shape);
    tf_vector way = tf_vector_difference(shape->corner[0], patch->apex);
    patch->normal = tf_vector_sum(patch->normal, 1, normal);
    patch->below += tf_vector_dot(way, normal);
}

tf_patch tf_patch_of_star(const tf_adaptive_surface *surface, int vertex,
                          tf_vector apex)
{
    tf_patch patch = {.apex = apex};
    int c = tf_first_corner(surface, vertex);
    for (; c != TF_NONE; c = tf_next_corner(surface, c)) {
        tf_shape shape = tf_shape_of(surface, c / 3);
        tf_patch_add(&patch, &shape);
    }
    return patch;
}

//: Find the position of an apex
tf_vector tf_patch_position(const tf_patch *patch, double more)
{
    double square = tf_vector_dot(patch->normal, patch->normal);
    double rise = (patch->below + more) / square;
    return tf_vector_sum(patch->apex, rise, patch->normal);
}
