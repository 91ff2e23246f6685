//: Include what scripts need
#include "simulate/script.h"

#include "geometry/vector.h"

#include <math.h>
#include <string.h>

//: Turn a vertex about an axis
/// Rodrigues' formula.
static tf_vector turned(const tf_script *script, double angle, tf_vector from)
{
    tf_vector axis = tf_vector_at(script->axis, 0);
    tf_vector center = tf_vector_at(script->center, 0);
    tf_vector arm = tf_vector_difference(from, center);
    double along = tf_vector_dot(axis, arm);
    tf_vector to = tf_vector_sum(center, cos(angle), arm);
    to = tf_vector_sum(to, sin(angle), tf_vector_cross(axis, arm));
    return tf_vector_sum(to, (1 - cos(angle)) * along, axis);
}

//: Place the vertices of a script
/// From 0 to 1, with a velocity that is 0 at both ends.
static double part_at(const tf_script *script, double time)
{
    double part = (time - script->begin) / (script->end - script->begin);
    part = fmin(fmax(part, 0), 1);
    return part * part * (3 - 2 * part);
}

void tf_script_place(const tf_script *script, const tf_body *body, double time,
                     double position[])
{
    double part = part_at(script, time);
    for (int v = script->first; v < script->first + script->count; v++) {
        tf_vector to = turned(script, part * script->turn,
                              tf_vector_at(body->position, v));
        to = tf_vector_sum(to, part, tf_vector_at(script->shift, 0));
        memcpy(position + (ptrdiff_t)3 * v, to.x, sizeof to.x);
    }
}
