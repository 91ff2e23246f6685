//: Include what the air needs
#include "simulate/air.h"

#include <math.h>

//: Blow from all sides
/// Two waves go with the wind, whose lengths have no common multiple.
static void find_wind(const tf_air *air, double time, const double x[3],
                      double wind[3])
{
    double speed = hypot(air->wind[0], air->wind[1]);
    double angle = atan2(air->wind[1], air->wind[0]) + air->veer * time;
    double ahead[] = {cos(angle), sin(angle)};
    double phase =
        2 * (x[0] * ahead[0] + x[1] * ahead[1] - speed * time);
    double sideways = air->gust * (sin(3 * phase) + sin(1.618 * phase));
    wind[0] = speed * ahead[0] - sideways * ahead[1];
    wind[1] = speed * ahead[1] + sideways * ahead[0];
    wind[2] = air->wind[2] + 0.3 * air->gust * sin(2.3 * phase + x[2]);
}

//: Push a triangle along its normal
static void cross(const double a[3], const double b[3], double product[3])
{
    for (int k = 0; k < 3; k++) {
        int l = (k + 1) % 3, m = (k + 2) % 3;
        product[k] = a[l] * b[m] - a[m] * b[l];
    }
}

/// Its normal, of the length of twice its area; its center; its velocity.
static void measure(const int corner[3], const double position[],
                    const double velocity[], double normal[3], double center[3],
                    double moving[3])
{
    double side[2][3];
    const double *x = position + 3 * corner[0];
    for (int k = 0; k < 3; k++) {
        center[k] = moving[k] = 0;
        for (int i = 0; i < 3; i++) {
            center[k] += position[3 * corner[i] + k] / 3;
            moving[k] += velocity[3 * corner[i] + k] / 3;
        }
        for (int i = 0; i < 2; i++)
            side[i][k] = position[3 * corner[i + 1] + k] - x[k];
    }
    cross(side[0], side[1], normal);
}

static void push(const tf_air *air, const tf_body *body, double time,
                 double step, const int corner[3], const double position[],
                 double velocity[])
{
    double normal[3], center[3], moving[3], wind[3], met = 0, square = 0;
    measure(corner, position, velocity, normal, center, moving);
    find_wind(air, time, center, wind);
    for (int k = 0; k < 3; k++) {
        met += normal[k] * (wind[k] - moving[k]);
        square += normal[k] * normal[k];
    }
    if (square == 0)
        return;
    // The force is drag times area times the part along the normal, and each
    // corner has a third of it.
    double impulse = step * air->drag * met / sqrt(square) / 6;
    for (int i = 0; i < 3; i++)
        if (body->mass[corner[i]] > 0)
            for (int k = 0; k < 3; k++)
                velocity[3 * corner[i] + k] +=
                    impulse * normal[k] / body->mass[corner[i]];
}

//: Blow on a body
void tf_air_blow(const tf_air *air, const tf_body *body, double time,
                 double step, const double position[], double velocity[])
{
    if (body->axes < 3)
        return;
    for (int t = 0; t < body->triangles; t++)
        push(air, body, time, step, body->triangle + 3 * t, position, velocity);
}
