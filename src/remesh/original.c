//: Make room for an original
#include "remesh/original.h"

#include "linear/distance.h"
#include "remesh/measure.h"

#include <string.h>

static bool reserve_original(tf_original *original)
{
    size_t triangles = (size_t)original->triangles;
    return tf_buffer_extend(&original->position, (size_t)original->vertices,
                            3 * sizeof(double)) &&
           tf_buffer_extend(&original->vertex, triangles, 3 * sizeof(int)) &&
           tf_buffer_extend(&original->box, triangles, sizeof(tf_aabb)) &&
           tf_buffer_extend(&original->order, triangles, sizeof(int)) &&
           tf_dynamic_tree_reserve(&original->tree, original->triangles);
}

//: Copy a surface
bool tf_original_copy(tf_original *original, const tf_adaptive_surface *surface)
{
    original->vertices = surface->vertices;
    original->triangles = surface->triangles;
    if (!reserve_original(original))
        return false;
    memcpy(original->position.data, surface->position.data,
           3 * sizeof(double) * (size_t)surface->vertices);
    memcpy(original->vertex.data, surface->vertex.data,
           3 * sizeof(int) * (size_t)surface->triangles);
    tf_aabb *box = original->box.data;
    int *order = original->order.data;
    for (int t = 0; t < surface->triangles; t++) {
        box[t] = tf_aabb_of(surface, 3, tf_triangle(surface, t));
        order[t] = t;
    }
    tf_dynamic_tree_build(&original->tree, box, order, surface->triangles);
    return true;
}

//: Free an original
void tf_original_free(tf_original *original)
{
    tf_buffer_free(&original->position);
    tf_buffer_free(&original->vertex);
    tf_buffer_free(&original->box);
    tf_buffer_free(&original->order);
    tf_dynamic_tree_free(&original->tree);
}

//: Take the corners of a triangle
static void take_corners(const tf_original *original, int triangle,
                         tf_vector corner[3])
{
    const int *vertex =
        (const int *)original->vertex.data + 3 * (ptrdiff_t)triangle;
    const double *position = original->position.data;
    for (int i = 0; i < 3; i++)
        memcpy(corner[i].x, position + 3 * (ptrdiff_t)vertex[i],
               sizeof corner[i].x);
}

//: Find the nearest point of a triangle
typedef struct nearest_search {
    const tf_original *original;
    tf_vector x[4]; ///< the point, and the corners of a triangle
} nearest_search;

static tf_point_pair nearest_of(nearest_search *search, int triangle)
{
    take_corners(search->original, triangle, search->x + 1);
    return tf_nearest_points(1, 3, search->x);
}

static double squared_distance(void *context, int triangle)
{
    double distance = nearest_of(context, triangle).distance;
    return distance * distance;
}

//: Find the nearest point of the original
double tf_original_nearest(tf_original *original, const double x[3],
                           double point[3])
{
    nearest_search search = {.original = original, .x = {{{x[0], x[1], x[2]}}}};
    double least;
    int triangle = tf_dynamic_tree_nearest(&original->tree, x, squared_distance,
                                           &search, &least);
    memcpy(point, x, 3 * sizeof *point);
    if (triangle < 0)
        return INFINITY;
    tf_point_pair nearest = nearest_of(&search, triangle);
    for (int k = 0; k < 3; k++)
        point[k] = nearest.weight[1] * search.x[1].x[k] +
                   nearest.weight[2] * search.x[2].x[k] +
                   nearest.weight[3] * search.x[3].x[k];
    return nearest.distance;
}

//: Find the greatest distance from the original
static tf_vector middle_of(const tf_original *original, int triangle)
{
    tf_vector corner[3], middle = {{0}};
    take_corners(original, triangle, corner);
    for (int i = 0; i < 3; i++)
        middle = tf_vector_sum(middle, 1.0 / 3, corner[i]);
    return middle;
}

double tf_original_farthest(tf_original *original, const tf_original *other)
{
    const double *position = other->position.data;
    double farthest = 0, point[3];
    for (int v = 0; v < other->vertices; v++)
        farthest = fmax(
            farthest,
            tf_original_nearest(original, position + 3 * (ptrdiff_t)v, point));
    for (int t = 0; t < other->triangles; t++)
        farthest =
            fmax(farthest,
                 tf_original_nearest(original, middle_of(other, t).x, point));
    return farthest;
}
