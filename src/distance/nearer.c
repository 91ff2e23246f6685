//: Include what the decision of nearness needs
#include "distance/nearer.h"

#include "distance/features.h"
#include "linear/distance.h"
#include "query/shape.h"

#include <float.h>
#include <math.h>

//: Bound the distance of two elements
/// Two elements relative to the first vertex of the first, rounded.
typedef struct rounded_elements {
    int vertices, others;
    tf_vector x[4];
    double size; ///< the largest coordinate of these
} rounded_elements;

static rounded_elements round_elements(tf_kind kind, const double *const x[])
{
    const tf_query_shape *shape = tf_query_shape_of(kind);
    rounded_elements e = {.vertices = shape->vertices, .others = shape->others};
    for (int v = 1; v < e.vertices + e.others; v++)
        for (int k = 0; k < shape->axes; k++) {
            e.x[v].x[k] = x[v][k] - x[0][k];
            e.size = fmax(e.size, fabs(e.x[v].x[k]));
        }
    return e;
}

//: Measure a gap along a vector
/// The least product of a vector with the differences of the elements' vertices,
/// less what rounding may have added.
static double least_along(const rounded_elements *e, tf_vector along)
{
    double least = INFINITY, length = 0;
    for (int k = 0; k < TF_AXES; k++)
        length += fabs(along.x[k]);
    for (int i = 0; i < e->vertices; i++)
        for (int j = e->vertices; j < e->vertices + e->others; j++) {
            tf_vector from = tf_vector_difference(e->x[j], e->x[i]);
            least = fmin(least, tf_vector_dot(along, from));
        }
    // Each coordinate of a difference is off by less than 4 u size, and each
    // product with it by less than 4 u times its own size, with u = 2^-53.
    return least - (0x1p-48 * e->size * length + 0x1p-1000);
}

/// Whether a vector shows that the elements are not nearer: no vector of length L
/// has products above d L with all differences of elements nearer than d.
static bool are_farther(const rounded_elements *e, tf_vector along,
                        double distance)
{
    double length = tf_vector_length(along);
    return least_along(e, along) > distance * length * (1 + 0x1p-46);
}

/// The vector between the middles of the elements.
static tf_vector between_middles(const rounded_elements *e)
{
    tf_vector between = {{0}};
    for (int i = 0; i < e->vertices + e->others; i++)
        between = tf_vector_sum(
            between, i < e->vertices ? -1.0 / e->vertices : 1.0 / e->others,
            e->x[i]);
    return between;
}

//: Find the vector between nearest points
static tf_vector between_nearest(const rounded_elements *e)
{
    tf_point_pair points = tf_nearest_points(e->vertices, e->others, e->x);
    tf_vector between = {{0}};
    for (int i = 0; i < e->vertices + e->others; i++)
        between = tf_vector_sum(
            between, i < e->vertices ? -points.weight[i] : points.weight[i],
            e->x[i]);
    return between;
}

//: Estimate whether elements are nearer
/// No distance is more than that of any two points.  The first vector that is
/// tried costs little, and decides most pairs.
int tf_estimate_nearer(tf_kind kind, const double *const x[], double distance)
{
    rounded_elements e = round_elements(kind, x);
    // Where this fails products may overflow, or have lost digits.
    if (!(e.size < 0x1p500 && distance < 0x1p500 && distance > 0x1p-400))
        return 0;
    if (are_farther(&e, between_middles(&e), distance))
        return -1;
    tf_vector between = between_nearest(&e);
    if (tf_vector_length(between) + 0x1p-46 * e.size < distance * (1 - 0x1p-46))
        return 1;
    return are_farther(&e, between, distance) ? -1 : 0;
}

//: Decide exactly whether elements are nearer
/// The elements are as near as the nearest features of which the nearest points
/// are unique and inside.
static bool are_nearer_exactly(tf_kind kind, const double *const x[],
                               double distance)
{
    const tf_features *features;
    int count = tf_features_of(kind, &features);
    tf_exact_vertices exact;
    tf_wide d, square, most;
    tf_feature_distance found;
    tf_exact_vertices_set(kind, x, distance, &exact);
    tf_wide_set(distance, exact.unit, &d);
    tf_wide_multiply(&d, &d, &square);
    for (int i = 0; i < count; i++) {
        if (!tf_feature_distance_find(&exact, &features[i], &found))
            continue;
        tf_wide_multiply(&square, &found.scale, &most);
        if (tf_wide_compare(&found.square, &most) == TF_NEGATIVE)
            return true;
    }
    return false;
}

bool tf_are_nearer(tf_kind kind, const double *const x[], double distance)
{
    int estimate = tf_estimate_nearer(kind, x, distance);
    return estimate != 0 ? estimate > 0 : are_nearer_exactly(kind, x, distance);
}
