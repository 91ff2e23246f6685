//: Include what handles need
#include "simulate/handle.h"

#include "simulate/triple.h"

#include <math.h>
#include <string.h>

//: Turn a vertex about an axis
/// Rodrigues' formula.
static tf_triple turned(const tf_handle *handle, double angle, tf_triple from)
{
    tf_triple axis = tf_triple_at(handle->axis, 0);
    tf_triple center = tf_triple_at(handle->center, 0);
    tf_triple arm = tf_triple_between(center, from);
    double along = tf_triple_dot(axis, arm);
    tf_triple to = tf_triple_sum(center, cos(angle), arm);
    to = tf_triple_sum(to, sin(angle), tf_triple_cross(axis, arm));
    return tf_triple_sum(to, (1 - cos(angle)) * along, axis);
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
        tf_triple to = turned(handle, part * handle->turn,
                              tf_triple_at(body->position, v));
        to = tf_triple_sum(to, part, tf_triple_at(handle->shift, 0));
        memcpy(position + (ptrdiff_t)3 * v, to.x, sizeof to.x);
    }
}
