//: Declare what is measured of triangles
#pragma once

#include "linear/distance.h"
#include "surgery/state.h"

#include <math.h>

// All of this is rounded: it decides what is wanted, never what is safe.

static inline tf_vector tf_vector_at(const tf_adaptive *of, int vertex)
{
    const double *x = tf_place(of, vertex);
    return (tf_vector){{x[0], x[1], x[2]}};
}

/// a + factor b.
static inline tf_vector tf_vector_sum(tf_vector a, double factor, tf_vector b)
{
    return (tf_vector){{a.x[0] + factor * b.x[0], a.x[1] + factor * b.x[1],
                        a.x[2] + factor * b.x[2]}};
}

static inline double tf_vector_length(tf_vector a)
{
    return sqrt(tf_vector_dot(a, a));
}

double tf_length_of(const tf_adaptive *of, int a, int b);

/// The point in the middle between two vertices.
tf_vector tf_middle_of(const tf_adaptive *of, int a, int b);

//: Declare what is measured of a triangle
/// The corners of a triangle.
typedef struct tf_shape {
    tf_vector corner[3];
} tf_shape;

tf_shape tf_shape_of(const tf_adaptive *of, int triangle);

/// The normal, as long as twice the area.
tf_vector tf_shape_normal(const tf_shape *shape);

/// From 0, for a triangle without area, to 1, for an equilateral one: the area
/// over the sum of the squares of its sides, scaled.
double tf_shape_quality(const tf_shape *shape);

/// Whether the angle between two normals has at least this cosine.
bool tf_normals_agree(tf_vector a, tf_vector b, double cosine);
