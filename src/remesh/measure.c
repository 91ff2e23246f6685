//: Measure edges
#include "remesh/measure.h"

#include "base/fail.h"

#include <limits.h>

double tf_length_of(const tf_adaptive_surface *surface, int a, int b)
{
    return tf_vector_length(tf_vector_difference(tf_position_of(surface, a),
                                                 tf_position_of(surface, b)));
}

tf_vector tf_middle_of(const tf_adaptive_surface *surface, int a, int b)
{
    tf_vector half = tf_vector_scaled(0.5, tf_position_of(surface, a));
    return tf_vector_sum(half, 0.5, tf_position_of(surface, b));
}

//: Measure triangles
tf_shape tf_shape_of(const tf_adaptive_surface *surface, int triangle)
{
    const int *vertex = tf_triangle(surface, triangle);
    tf_shape shape;
    for (int i = 0; i < 3; i++)
        shape.corner[i] = tf_position_of(surface, vertex[i]);
    return shape;
}

tf_vector tf_shape_normal(const tf_shape *shape)
{
    const tf_vector *x = shape->corner;
    return tf_vector_cross(tf_vector_difference(x[1], x[0]),
                           tf_vector_difference(x[2], x[0]));
}

double tf_shape_quality(const tf_shape *shape)
{
    double squares = 0;
    for (int i = 0; i < 3; i++) {
        tf_vector side =
            tf_vector_difference(shape->corner[(i + 1) % 3], shape->corner[i]);
        squares += tf_vector_dot(side, side);
    }
    double area = tf_vector_length(tf_shape_normal(shape));
    return squares > 0 ? 2 * sqrt(3) * area / squares : 0;
}

double tf_worse_quality(const tf_shape pair[2])
{
    return fmin(tf_shape_quality(&pair[0]), tf_shape_quality(&pair[1]));
}

bool tf_normals_agree(tf_vector a, tf_vector b, double cosine)
{
    return tf_vector_dot(a, b) >=
           cosine * tf_vector_length(a) * tf_vector_length(b);
}

//: Find the middle of a star
tf_vector tf_star_middle(const tf_adaptive_surface *surface, int vertex)
{
    tf_vector sum = {{0}};
    double total = 0;
    int c = tf_first_corner(surface, vertex);
    for (; c != TF_NONE; c = tf_next_corner(surface, c)) {
        tf_shape shape = tf_shape_of(surface, c / 3);
        double area = tf_vector_length(tf_shape_normal(&shape));
        for (int i = 0; i < 3; i++)
            sum = tf_vector_sum(sum, area / 3, shape.corner[i]);
        total += area;
    }
    return total > 0 ? tf_vector_scaled(1 / total, sum)
                     : tf_position_of(surface, vertex);
}

//: Judge the triangles of a star
/// What is worst among some triangles, before and after a change.
typedef struct judgment {
    double before, after; ///< the least quality
    bool turned;          ///< some triangle is turned over
} judgment;

static void judge_triangle(judgment *all, const tf_shape *before,
                           const tf_shape *after)
{
    all->before = fmin(all->before, tf_shape_quality(before));
    all->after = fmin(all->after, tf_shape_quality(after));
    all->turned |=
        !tf_normals_agree(tf_shape_normal(before), tf_shape_normal(after), 0.9);
}

//: Judge the star of a vertex
static bool has_vertex_too(const tf_adaptive_surface *surface, int corner,
                           int other)
{
    return tf_vertex_at(surface, tf_corner_after(corner)) == other ||
           tf_vertex_at(surface, tf_corner_before(corner)) == other;
}

bool tf_star_stays_good(const tf_adaptive_surface *surface, int vertex,
                        int other, tf_vector position)
{
    judgment all = {.before = 1, .after = 1};
    int c = tf_first_corner(surface, vertex);
    for (; c != TF_NONE; c = tf_next_corner(surface, c)) {
        if (has_vertex_too(surface, c, other))
            continue;
        tf_shape before = tf_shape_of(surface, c / 3), after = before;
        after.corner[c % 3] = position;
        judge_triangle(&all, &before, &after);
    }
    return !all.turned && (all.after >= all.before || all.after >= 0.6);
}

//: Choose the scale of a surface
void tf_choose_scale(tf_adaptive_surface *surface)
{
    tf_aabb whole = tf_aabb_empty();
    for (int v = 0; v < surface->vertices; v++)
        if (tf_first_corner(surface, v) != TF_NONE)
            tf_aabb_add(&whole, tf_vertex_coordinates(surface, v));
    surface->scale = tf_aabb_scale(&whole);
}

//: Check that nothing measured overflows
tf_status tf_check_coordinates(const tf_adaptive_surface *surface, double most,
                               tf_error *error)
{
    for (int v = 0; v < surface->vertices; v++) {
        tf_vector x = tf_vector_at(tf_vertex_coordinates(surface, v), 0);
        bool small = fabs(x.x[0]) <= most && fabs(x.x[1]) <= most &&
                     fabs(x.x[2]) <= most;
        if (!small && tf_first_corner(surface, v) != TF_NONE)
            return tf_fail_vertex(error, TF_OUT_OF_RANGE, v, -1);
    }
    return tf_fail(error, TF_OK);
}

//: Estimate how many triangles there will be
/// Equilateral ones with sides of that length, which have as much area as the
/// surface.
static double triangles_of(const tf_adaptive_surface *surface, double edge)
{
    double count = 0;
    for (int t = 0; t < surface->triangles; t++) {
        if (!tf_is_triangle(surface, t))
            continue;
        tf_shape shape = tf_shape_of(surface, t);
        for (int i = 0; i < 3; i++)
            shape.corner[i] = tf_vector_scaled(1 / edge, shape.corner[i]);
        count += tf_vector_length(tf_shape_normal(&shape)) * 2 / sqrt(3);
    }
    return count;
}

tf_status tf_check_target(const tf_adaptive_surface *surface, double edge,
                          tf_error *error)
{
    if (!(edge > 0) || !isfinite(edge))
        return tf_fail_option(error, "edge", "above 0", edge);
    if (!(triangles_of(surface, edge * surface->scale) <= INT_MAX / 3.0))
        return tf_fail_option(error, "edge",
                              "so long that an int can count the corners of "
                              "all triangles",
                              edge);
    return tf_fail(error, TF_OK);
}
