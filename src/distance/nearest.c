//: Include what nearest points need
#include "distance/nearest.h"

#include "distance/features.h"
#include "query/shape.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <string.h>

//: Take the root of a square
/// number 2^exponent: a number from 1/2 up to 1, or zero.
typedef struct scaled_length {
    double number;
    int exponent;
} scaled_length;

static bool is_shorter(scaled_length a, scaled_length b)
{
    if (a.number == 0 || b.number == 0)
        return a.number < b.number;
    return a.exponent != b.exponent ? a.exponent < b.exponent
                                    : a.number < b.number;
}

/// The distance of two features, with a relative error below 3 u, u = 2^-53: two
/// roundings and a quotient, halved by the root, and its own.
static scaled_length length_of(const tf_feature_distance *found, int unit)
{
    int above, below;
    double square = tf_wide_round(&found->square, &above);
    square /= tf_wide_round(&found->scale, &below);
    int exponent = above - below + 2 * unit;
    bool odd = exponent % 2 != 0;
    scaled_length length = {.exponent = (exponent - odd) / 2};
    int more;
    length.number = frexp(sqrt(odd ? 2 * square : square), &more);
    length.exponent += more;
    return length;
}

//: Certify a distance
/// Doubles from which rounding and, below the normal numbers, the scaling has
/// taken nothing.
static void certify(scaled_length length, tf_nearest *nearest)
{
    double low = length.number * (1 - 0x1p-51);
    double high = length.number * (1 + 0x1p-51);
    nearest->lower = ldexp(low, length.exponent);
    nearest->upper = ldexp(high, length.exponent);
    if (ldexp(nearest->lower, -length.exponent) > low)
        nearest->lower = nextafter(nearest->lower, 0);
    if (ldexp(nearest->upper, -length.exponent) < high)
        nearest->upper = nextafter(nearest->upper, INFINITY);
}

//: Find the nearest features
static void give_weights(const tf_query_shape *shape, const double weight[],
                         tf_nearest *nearest)
{
    for (int i = 0; i < shape->vertices; i++)
        nearest->barycentric[0][i] = weight[i];
    for (int i = 0; i < shape->others; i++)
        nearest->barycentric[1][i] = weight[shape->vertices + i];
}

tf_nearest tf_nearest_of(tf_kind kind, const double *const x[])
{
    const tf_features *features;
    int count = tf_features_of(kind, &features);
    scaled_length best = {1, INT_MAX};
    double weight[4];
    tf_exact_vertices exact;
    tf_exact_vertices_set(kind, x, 0, &exact);
    for (int i = 0; i < count; i++) {
        tf_feature_distance found;
        if (!tf_feature_distance_find(&exact, &features[i], &found))
            continue;
        scaled_length own = length_of(&found, exact.unit);
        if (!is_shorter(own, best))
            continue;
        best = own;
        memcpy(weight, found.weight, sizeof weight);
    }
    tf_nearest nearest = {0};
    certify(best, &nearest);
    give_weights(tf_query_shape_of(kind), weight, &nearest);
    return nearest;
}
