//: Include what the air needs
#include "simulate/air.h"

#include "geometry/vector.h"

#include <math.h>

//: Blow from all sides
/// Waves go with the wind, whose lengths have no short common multiple.
static void find_wind(const tf_air *air, int up, double time, const double x[3],
                      double wind[3])
{
    int east = (up + 1) % 3, north = (up + 2) % 3;
    double speed = hypot(air->wind[east], air->wind[north]);
    double angle = atan2(air->wind[north], air->wind[east]) + air->veer * time;
    double ahead[] = {cos(angle), sin(angle)};
    double phase =
        2 * (x[east] * ahead[0] + x[north] * ahead[1] - speed * time);
    double sideways = air->gust * (sin(3 * phase) + sin(1.618 * phase));
    wind[east] = speed * ahead[0] - sideways * ahead[1];
    wind[north] = speed * ahead[1] + sideways * ahead[0];
    wind[up] = air->wind[up] + 0.3 * air->gust * sin(2.3 * phase + x[up]);
}

//: Push a triangle along its normal
/// The mean of what its corners have.
static tf_vector mean_at(const int corner[3], const double value[])
{
    tf_vector mean = {{0}};
    for (int i = 0; i < 3; i++)
        mean = tf_vector_sum(mean, 1.0 / 3, tf_vector_at(value, corner[i]));
    return mean;
}

/// Its length is twice the area.
static tf_vector normal_of(const int corner[3], const double position[])
{
    tf_vector a = tf_vector_at(position, corner[0]);
    tf_vector b = tf_vector_at(position, corner[1]);
    tf_vector c = tf_vector_at(position, corner[2]);
    return tf_vector_cross(tf_vector_difference(b, a),
                           tf_vector_difference(c, a));
}

static void push(const tf_air *air, const tf_body *body, double time,
                 double step, const int corner[3], const double position[],
                 double velocity[])
{
    tf_vector wind = {{0}}, normal = normal_of(corner, position);
    double length = tf_vector_length(normal);
    if (length == 0)
        return;
    find_wind(air, tf_body_up(body), time, mean_at(corner, position).x, wind.x);
    tf_vector met = tf_vector_difference(wind, mean_at(corner, velocity));
    // The force is drag times area times the part along the normal, and each
    // corner has a third of it.
    double impulse = step * air->drag * tf_vector_dot(normal, met) / length / 6;
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
