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
} nearest_search;

static tf_point_pair nearest_of(nearest_search *search, int triangle)
{
    tf_shape shape = tf_shape_of(search->original->surface, triangle);
    memcpy(search->x + 1, shape.corner, sizeof shape.corner);
    return tf_nearest_points(1, 3, search->x);
}

/// Whether rounding leaves nothing of a triangle's normal.
static bool is_sliver(const tf_shape *shape, double area2)
{
    tf_vector side = tf_vector_difference(shape->corner[1], shape->corner[0]);
    tf_vector other = tf_vector_difference(shape->corner[2], shape->corner[0]);
    double length2 = tf_vector_dot(side, side) + tf_vector_dot(other, other);
    return !(area2 > 0x1p-60 * length2 * length2);
}

/// The square of the distance from the start of an edge, less what is along it.
static double squared_from_edge(tf_vector edge, tf_vector gap)
{
    double along = tf_vector_dot(gap, edge),
           length2 = tf_vector_dot(edge, edge);
    double part = along <= 0 ? 0 : along >= length2 ? 1 : along / length2;
    gap = tf_vector_sum(gap, -part, edge);
    return tf_vector_dot(gap, gap);
}

/// From the edges that the point is beyond, or else from the plane.  This is
/// asked more often than anything else, so that it has its own arithmetic.
static double squared_distance(void *context, int triangle)
{
    nearest_search *search = context;
    tf_shape shape = tf_shape_of(search->original->surface, triangle);
    tf_vector normal = tf_shape_normal(&shape), gap = {{0}};
    double area2 = tf_vector_dot(normal, normal), least = INFINITY;
    if (is_sliver(&shape, area2)) {
        double distance = nearest_of(search, triangle).distance;
        return distance * distance;
    }
    for (int i = 0; i < 3; i++) {
        tf_vector edge =
            tf_vector_difference(shape.corner[(i + 1) % 3], shape.corner[i]);
        gap = tf_vector_difference(search->x[0], shape.corner[i]);
        if (tf_vector_dot(tf_vector_cross(edge, gap), normal) < 0) {
            double from_edge = squared_from_edge(edge, gap);
            least = from_edge < least ? from_edge : least;
        }
    }
    double height = tf_vector_dot(gap, normal);
    return isfinite(least) ? least : height * height / area2;
}

//: Find the nearest point of the original
tf_projection tf_original_project(tf_original *original, tf_vector point)
{
    nearest_search search = {.original = original, .x = {point}};
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
