//: Include what the air needs
#include "simulate/air.h"

#include "simulate/triple.h"

#include <math.h>

//: Blow from all sides
/// Two waves go with the wind, whose lengths have no common multiple.
static void find_wind(const tf_air *air, double time, const double x[3],
                      double wind[3])
{
    double speed = hypot(air->wind[0], air->wind[1]);
    double angle = atan2(air->wind[1], air->wind[0]) + air->veer * time;
    double ahead[] = {cos(angle), sin(angle)};
    double phase = 2 * (x[0] * ahead[0] + x[1] * ahead[1] - speed * time);
    double sideways = air->gust * (sin(3 * phase) + sin(1.618 * phase));
    wind[0] = speed * ahead[0] - sideways * ahead[1];
    wind[1] = speed * ahead[1] + sideways * ahead[0];
    wind[2] = air->wind[2] + 0.3 * air->gust * sin(2.3 * phase + x[2]);
}

//: Push a triangle along its normal
/// The mean of what its corners have.
static tf_triple mean_at(const int corner[3], const double of[])
{
    tf_triple mean = {{0}};
    for (int i = 0; i < 3; i++)
        mean = tf_triple_sum(mean, 1.0 / 3, tf_triple_at(of, corner[i]));
    return mean;
}

/// Its length is twice the area.
static tf_triple normal_of(const int corner[3], const double position[])
{
    tf_triple a = tf_triple_at(position, corner[0]);
    tf_triple b = tf_triple_at(position, corner[1]);
    tf_triple c = tf_triple_at(position, corner[2]);
    return tf_triple_cross(tf_triple_between(a, b), tf_triple_between(a, c));
}

static void push(const tf_air *air, const tf_body *body, double time,
                 double step, const int corner[3], const double position[],
                 double velocity[])
{
    tf_triple wind = {{0}}, normal = normal_of(corner, position);
    double length = tf_triple_length(normal);
    if (length == 0)
        return;
    find_wind(air, time, mean_at(corner, position).x, wind.x);
    tf_triple met = tf_triple_between(mean_at(corner, velocity), wind);
    // The force is drag times area times the part along the normal, and each
    // corner has a third of it.
    double impulse = step * air->drag * tf_triple_dot(normal, met) / length / 6;
    for (int i = 0; i < 3; i++)
        if (body->mass[corner[i]] > 0)
            for (int k = 0; k < 3; k++)
                velocity[3 * corner[i] + k] +=
                    impulse * normal.x[k] / body->mass[corner[i]];
}

//: Blow on a body
void tf_air_blow(const tf_air *air, const tf_body *body, double time,
                 double step, const double position[], double velocity[])
{
    if (body->axes < 3)
        return;
    for (int t = 0; t < body->triangles; t++)
        push(air, body, time, step, body->triangle + (ptrdiff_t)3 * t, position,
             velocity);
}
