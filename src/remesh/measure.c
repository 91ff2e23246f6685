//: Measure edges
#include "remesh/measure.h"

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
    return 2 * sqrt(3) * area / squares;
}

bool tf_normals_agree(tf_vector a, tf_vector b, double cosine)
{
    return tf_vector_dot(a, b) >=
           cosine * tf_vector_length(a) * tf_vector_length(b);
}
