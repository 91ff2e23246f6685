//: Make room for an original
#include "remesh/original.h"

#include "linear/distance.h"
#include "remesh/measure.h"

#include <string.h>

static bool reserve_original(tf_original *original, int triangles)
{
    size_t count = (size_t)triangles;
    return tf_buffer_extend(&original->box, count, sizeof(tf_aabb)) &&
           tf_buffer_extend(&original->order, count, sizeof(int)) &&
           tf_dynamic_tree_reserve(&original->tree, triangles);
}

//: Begin with a surface
tf_status tf_original_begin(tf_original *original,
                            const tf_adaptive_surface *surface, tf_watch *watch)
{
    int count = 0;
    original->surface = surface;
    if (!reserve_original(original, surface->triangles))
        return TF_OUT_OF_MEMORY;
    tf_aabb *box = original->box.data;
    int *order = original->order.data;
    for (int t = 0; t < surface->triangles; t++) {
        if (t % 4096 == 0 && !tf_watch_done(watch, 0))
            return TF_CANCELLED;
        if (!tf_is_triangle(surface, t))
            continue;
        tf_shape shape = tf_shape_of(surface, t);
        box[t] = tf_aabb_empty();
        for (int i = 0; i < 3; i++)
            tf_aabb_add(&box[t], shape.corner[i].x);
        order[count++] = t;
    }
    return tf_dynamic_tree_build(&original->tree, box, order, count, watch)
               ? TF_OK
               : TF_CANCELLED;
}

void tf_original_free(tf_original *original)
{
    tf_buffer_free(&original->box);
    tf_buffer_free(&original->order);
    tf_dynamic_tree_free(&original->tree);
}

//: Find the nearest point of a triangle
typedef struct nearest_search {
    const tf_original *original;
    tf_vector x[4]; ///< the point, and the corners of a triangle
    double least;   ///< the square of the least distance so far
} nearest_search;

static tf_point_pair nearest_of(nearest_search *search, int triangle)
{
    tf_shape shape = tf_shape_of(search->original->surface, triangle);
    memcpy(search->x + 1, shape.corner, sizeof shape.corner);
    return tf_nearest_points(1, 3, search->x);
}

/// What is clearly not the nearest needn't be measured well.
static double squared_distance(void *context, int triangle)
{
    nearest_search *search = context;
    tf_shape shape = tf_shape_of(search->original->surface, triangle);
    memcpy(search->x + 1, shape.corner, sizeof shape.corner);
    double roughly = tf_squared_distance(search->x);
    if (roughly > 1.001 * search->least)
        return roughly;
    double distance = tf_nearest_points(1, 3, search->x).distance;
    search->least = fmin(search->least, distance * distance);
    return distance * distance;
}

//: Find the nearest point of the original
tf_projection tf_original_project(tf_original *original, tf_vector point)
{
    nearest_search search = {
        .original = original, .x = {point}, .least = INFINITY};
    tf_projection found = {.point = point, .distance = INFINITY};
    double least;
    int triangle = tf_dynamic_tree_nearest(&original->tree, point.x,
                                           squared_distance, &search, &least);
    if (triangle < 0)
        return found;
    tf_point_pair nearest = nearest_of(&search, triangle);
    const double *weight = nearest.weight + 1;
    found.distance = nearest.distance;
    found.origin.triangle = triangle;
    memcpy(found.origin.barycentric, weight, sizeof found.origin.barycentric);
    for (int k = 0; k < 3; k++)
        found.point.x[k] = weight[0] * search.x[1].x[k] +
                           weight[1] * search.x[2].x[k] +
                           weight[2] * search.x[3].x[k];
    return found;
}
