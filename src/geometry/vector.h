//: Declare vectors
#pragma once

#include "base/always_inline.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

enum {
    TF_AXES = 3 ///< the most axes of space
};

/// A vector of space, by axis.  In the plane x[2] is zero.  All operations on
/// vectors round: they measure, they never decide whether elements meet.
typedef struct tf_vector {
    double x[TF_AXES];
} tf_vector;

/// The position of a vertex, of an array with three coordinates per vertex.
TF_ALWAYS_INLINE tf_vector tf_vector_at(const double x[], int vertex)
{
    x += (ptrdiff_t)TF_AXES * vertex;
    return (tf_vector){{x[0], x[1], x[2]}};
}

//: Add and scale vectors
TF_ALWAYS_INLINE tf_vector tf_vector_scaled(double factor, tf_vector a)
{
    return (tf_vector){{factor * a.x[0], factor * a.x[1], factor * a.x[2]}};
}

/// a + factor b.
TF_ALWAYS_INLINE tf_vector tf_vector_sum(tf_vector a, double factor,
                                         tf_vector b)
{
    return (tf_vector){{a.x[0] + factor * b.x[0], a.x[1] + factor * b.x[1],
                        a.x[2] + factor * b.x[2]}};
}

/// a - b, the vector from b to a.
TF_ALWAYS_INLINE tf_vector tf_vector_difference(tf_vector a, tf_vector b)
{
    return (tf_vector){{a.x[0] - b.x[0], a.x[1] - b.x[1], a.x[2] - b.x[2]}};
}

/// Whether all coordinates are the same.
TF_ALWAYS_INLINE bool tf_vector_equals(tf_vector a, tf_vector b)
{
    return a.x[0] == b.x[0] && a.x[1] == b.x[1] && a.x[2] == b.x[2];
}

//: Take products of vectors
TF_ALWAYS_INLINE double tf_vector_dot(tf_vector a, tf_vector b)
{
    return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2];
}

TF_ALWAYS_INLINE tf_vector tf_vector_cross(tf_vector a, tf_vector b)
{
    return (tf_vector){{a.x[1] * b.x[2] - a.x[2] * b.x[1],
                        a.x[2] * b.x[0] - a.x[0] * b.x[2],
                        a.x[0] * b.x[1] - a.x[1] * b.x[0]}};
}

TF_ALWAYS_INLINE double tf_vector_length(tf_vector a)
{
    return sqrt(tf_vector_dot(a, a));
}

/// The vector of length 1 in the direction of a, which is not zero.
TF_ALWAYS_INLINE tf_vector tf_vector_unit(tf_vector a)
{
    return tf_vector_scaled(1 / tf_vector_length(a), a);
}
