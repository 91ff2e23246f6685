//: Include what velocities need
#include "intersect/velocity.h"

#include <float.h>
#include <math.h>

//: Find the relative velocity
static double saturate(double x)
{
    return fmax(-DBL_MAX, fmin(x, DBL_MAX));
}

/// The displacement of a simplex, that of its pivot, times `scale`.
static double displacement(const tf_simplex *simplex, int axis, double scale)
{
    const tf_event *start = simplex->event[simplex->pivot];
    const tf_event *end = simplex->event[simplex->pivot + 1];
    return end->x[axis] * scale - start->x[axis] * scale;
}

static double relative_displacement(const tf_simplex *s, const tf_simplex *r,
                                    int axis)
{
    double plain = displacement(s, axis, 1) - displacement(r, axis, 1);
    if (isfinite(plain))
        return plain;

    // At a quarter of their size the displacements cannot overflow.
    double quarter = displacement(s, axis, 0.25) - displacement(r, axis, 0.25);
    return saturate(4 * quarter);
}

tf_vector tf_relative_velocity(int axes, const tf_simplex *s,
                               const tf_simplex *r)
{
    tf_vector velocity = {{0, 0, 0}};
    for (int k = 0; k < axes; k++)
        velocity.x[k] = relative_displacement(s, r, k);
    return velocity;
}

//: Find the normal velocity
double tf_normal_velocity(tf_vector velocity, tf_vector normal)
{
    double plain = tf_vector_dot(velocity, normal);
    if (isfinite(plain))
        return plain;
    tf_vector quarter = tf_vector_scaled(0.25, velocity);
    return saturate(4 * tf_vector_dot(quarter, normal));
}
