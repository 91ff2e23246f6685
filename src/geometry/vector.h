//: Declare vectors
#pragma once

enum {
    TF_AXES = 3 ///< the most axes of space
};

/// A vector of space, by axis.  In the plane x[2] is zero.
typedef struct tf_vector {
    double x[TF_AXES];
} tf_vector;

static inline tf_vector tf_vector_scaled(double factor, tf_vector a)
{
    return (tf_vector){{factor * a.x[0], factor * a.x[1], factor * a.x[2]}};
}

static inline double tf_vector_dot(tf_vector a, tf_vector b)
{
    return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2];
}
