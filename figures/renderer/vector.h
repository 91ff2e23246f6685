// Vectors of space and points of the page, both passed by value.
#ifndef FIG_RENDERER_VECTOR_H
#define FIG_RENDERER_VECTOR_H

#include "geometry/vector.h"

#include <math.h>

/// A point of a page, in points of print, or of a plot, in its numbers.
typedef struct fig_point {
    double x, y;
} fig_point;

static inline tf_vector fig_vector_of(const double x[3])
{
    return (tf_vector){{x[0], x[1], x[2]}};
}

/// a + scale b
static inline tf_vector fig_combination(tf_vector a, double scale, tf_vector b)
{
    for (int k = 0; k < 3; k++)
        a.x[k] += scale * b.x[k];
    return a;
}

static inline tf_vector fig_sum(tf_vector a, tf_vector b)
{
    return fig_combination(a, 1, b);
}

static inline tf_vector fig_difference(tf_vector a, tf_vector b)
{
    return fig_combination(a, -1, b);
}

/// (1 - t) a + t b
static inline tf_vector fig_lerp(tf_vector a, tf_vector b, double t)
{
    return fig_combination(tf_vector_scaled(1 - t, a), t, b);
}

static inline tf_vector fig_cross(tf_vector a, tf_vector b)
{
    return (tf_vector){{a.x[1] * b.x[2] - a.x[2] * b.x[1],
                        a.x[2] * b.x[0] - a.x[0] * b.x[2],
                        a.x[0] * b.x[1] - a.x[1] * b.x[0]}};
}

static inline double fig_length(tf_vector a)
{
    return sqrt(tf_vector_dot(a, a));
}

/// The vector of length 1 in the direction of `a`; zero if that is zero.
static inline tf_vector fig_normalized(tf_vector a)
{
    double length = fig_length(a);
    for (int k = 0; k < 3 && length > 0; k++)
        a.x[k] /= length;
    return a;
}

#endif
