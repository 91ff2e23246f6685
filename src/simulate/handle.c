//: Include what handles need
#include "simulate/handle.h"

#include <math.h>

//: Turn a vertex about an axis
/// Rodrigues' formula.
static void turn(const tf_handle *handle, double angle, const double from[3],
                 double to[3])
{
    const double *n = handle->axis;
    double r[3], along = 0, c = cos(angle), s = sin(angle);
    for (int k = 0; k < 3; k++) {
        r[k] = from[k] - handle->center[k];
        along += n[k] * r[k];
    }
    for (int k = 0; k < 3; k++) {
        int l = (k + 1) % 3, m = (k + 2) % 3;
        to[k] = handle->center[k] + c * r[k] +
                s * (n[l] * r[m] - n[m] * r[l]) + (1 - c) * along * n[k];
    }
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
        turn(handle, part * handle->turn, body->position + 3 * v,
             position + 3 * v);
        for (int k = 0; k < 3; k++)
            position[3 * v + k] += part * handle->shift[k];
    }
}
