//: List the differences of two elements
#include "query/apart.h"

#include "arithmetic/clamped.h"
#include "arithmetic/functions.h"
#include "query/shape.h"

int tf_list_differences(int corners, int others, const double *const x[],
                        int count, tf_vector difference[])
{
    for (int i = 0; i < corners; i++)
        for (int j = corners; j < corners + others; j++)
            difference[count++] = tf_vector_difference(tf_vector_at(x[j], 0),
                                                       tf_vector_at(x[i], 0));
    return count;
}

//: Start from the center of the differences
/// The mean, but for a factor: a direction like any other.  Limits
/// the coordinates, so that no product overflows: a NaN, too, is over the limit.
static bool find_center(int count, const tf_vector difference[],
                        tf_vector *center)
{
    bool limited = true;
    *center = (tf_vector){{0}};
    for (int i = 0; i < count; i++)
        for (int k = 0; k < TF_AXES; k++) {
            limited = limited && fabs(difference[i].x[k]) <= 0x1p298;
            center->x[k] += difference[i].x[k] / TF_MOST_DIFFERENCES;
        }
    return limited;
}

//: Tell whether a difference is certainly positive along a direction
/// Whether the dot product, from the exact difference of the vertices, is.
static bool certainly_positive(tf_vector along, tf_vector difference)
{
    double a = along.x[0] * difference.x[0];
    double b = along.x[1] * difference.x[1];
    double c = along.x[2] * difference.x[2];
    double size = fabs(a) + fabs(b) + fabs(c);
    // Rounding loses less than 5 u size, with u = 2^-53, and underflow less than
    // 2^-1000.
    return a + b + c > 0x1p-49 * size + 0x1p-1000;
}

//: Find the difference that is least far along a direction
static int find_least(int count, const tf_vector difference[], tf_vector along)
{
    int least = 0;
    double distance = tf_vector_dot(difference[0], along);
    for (int i = 1; i < count; i++) {
        double own = tf_vector_dot(difference[i], along);
        if (own < distance) {
            distance = own;
            least = i;
        }
    }
    return least;
}

static bool all_certainly_positive(int count, const tf_vector difference[],
                                   tf_vector along)
{
    for (int i = 0; i < count; i++)
        if (!certainly_positive(along, difference[i]))
            return false;
    return true;
}

//: Turn a direction toward a difference
/// The point nearest to the origin between two points.
static tf_vector nearest_between(tf_vector from, tf_vector to)
{
    tf_vector step = tf_vector_difference(to, from);
    double square = tf_vector_dot(step, step);
    double share = -tf_vector_dot(from, step) / square;
    return share > 0 ? tf_vector_sum(from, share < 1 ? share : 1, step) : from;
}

//: Look for a direction that separates
bool tf_certainly_apart(int count, const tf_vector difference[])
{
    enum {
        MOST_TURNS = 8
    };
    tf_vector along;
    if (!find_center(count, difference, &along))
        return false;
    for (int turn = 0; turn < MOST_TURNS; turn++) {
        int least = find_least(count, difference, along);
        if (certainly_positive(along, difference[least]))
            return all_certainly_positive(count, difference, along);
        along = nearest_between(along, difference[least]);
    }
    return false;
}

//: Be certain of a query
bool tf_query_certainly_apart(const tf_queries *queries, size_t query)
{
    const tf_query_shape *shape = tf_query_shape_of(queries->kind);
    const int *vertex = queries->vertices + 4 * query;
    tf_vector difference[TF_MOST_DIFFERENCES];
    int count = 0;
    for (int t = 0; t < 2; t++) {
        const double *at = t ? queries->motion->end : queries->motion->start;
        const double *x[4];
        for (int v = 0; v < 4; v++)
            x[v] = at + (ptrdiff_t)3 * vertex[v];
        count = tf_list_differences(shape->vertices, shape->others, x, count,
                                    difference);
    }
    return tf_certainly_apart(count, difference);
}

static tf_sign certain_sign(const tf_differences *differences)
{
    return tf_clamped.sign(differences);
}

static tf_value certain_value(const tf_differences *differences)
{
    return tf_clamped.value(differences);
}

const tf_arithmetic tf_certain = {
    .name = "certain", .sign = certain_sign, .value = certain_value};
