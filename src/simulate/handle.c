//: Include what handles need
#include "simulate/handle.h"

#include "geometry/vector.h"

#include <math.h>
#include <string.h>

//: Turn a vertex about an axis
/// Rodrigues' formula.
static tf_vector turned(const tf_handle *handle, double angle, tf_vector from)
{
    tf_vector axis = tf_vector_at(handle->axis, 0);
    tf_vector center = tf_vector_at(handle->center, 0);
    tf_vector arm = tf_vector_difference(from, center);
    double along = tf_vector_dot(axis, arm);
    tf_vector to = tf_vector_sum(center, cos(angle), arm);
    to = tf_vector_sum(to, sin(angle), tf_vector_cross(axis, arm));
    return tf_vector_sum(to, (1 - cos(angle)) * along, axis);
}

//: Place a handle
/// From 0 to 1, with a velocity that is 0 at both ends.
static double part_at(const tf_handle *handle, double time)
{
    double part = (time - handle->begin) / (handle->end - handle->begin);
    part = fmin(fmax(part, 0), 1);
    return part * part * (3 - 2 * part);
}

void tf_handle_place(const tf_handle *handle, const tf_body *body, double time,
                     double position[])
{
    double part = part_at(handle, time);
    for (int v = handle->first; v < handle->first + handle->count; v++) {
        tf_vector to = turned(handle, part * handle->turn,
                              tf_vector_at(body->position, v));
        to = tf_vector_sum(to, part, tf_vector_at(handle->shift, 0));
        memcpy(position + (ptrdiff_t)3 * v, to.x, sizeof to.x);
    }
}
