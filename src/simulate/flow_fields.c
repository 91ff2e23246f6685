//: Include what velocity fields need
#include "simulate/flow_fields.h"

#include "simulate/triple.h"

#include <math.h>

static const double pi = 3.141592653589793;

//: Apply a field point by point
typedef tf_triple field(double time, tf_triple at);

static void apply_field(field *of, double time, int points,
                        const double point[], double velocity[])
{
    for (int i = 0; i < points; i++) {
        tf_triple v = of(time, tf_triple_at(point, i));
        memcpy(velocity + 3 * (ptrdiff_t)i, v.x, sizeof v.x);
    }
}

//: Splash
/// What comes along the axis must go outwards: v = -f at x, and r f' / 2 at the
/// distance r from the axis.
static tf_triple splash(double time, tf_triple at)
{
    const double speed = 0.25 * cos(pi * time / 3), width = 0.1;
    double slowing = tanh(at.x[0] / width);
    double out = speed / width * (1 - slowing * slowing) / 2;
    return (tf_triple){{-speed * slowing, out * at.x[1], out * at.x[2]}};
}

void tf_flow_splash(void *context, double time, int points,
                    const double point[], const double normal[],
                    double velocity[])
{
    (void)context, (void)normal;
    apply_field(splash, time, points, point, velocity);
}

//: Squeeze
/// As for a splash, with f' = -2 exp(-(x / width)^2).
static tf_triple squeeze(double time, tf_triple at)
{
    (void)time;
    const double speed = 2, width = 0.12;
    double near = speed * exp(-at.x[0] * at.x[0] / (width * width));
    double along = speed * width * sqrt(pi) * erf(at.x[0] / width);
    return (tf_triple){{along, -near * at.x[1], -near * at.x[2]}};
}

void tf_flow_squeeze(void *context, double time, int points,
                     const double point[], const double normal[],
                     double velocity[])
{
    (void)context, (void)normal;
    apply_field(squeeze, time, points, point, velocity);
}

//: Stir by vortices
static tf_triple vortices(double time, tf_triple at)
{
    double once[3], twice[3], now = cos(pi * time / 3);
    for (int k = 0; k < 3; k++) {
        once[k] = sin(pi * at.x[k]) * sin(pi * at.x[k]);
        twice[k] = sin(2 * pi * at.x[k]);
    }
    return (tf_triple){{2 * now * once[0] * twice[1] * twice[2],
                        -now * twice[0] * once[1] * twice[2],
                        -now * twice[0] * twice[1] * once[2]}};
}

void tf_flow_vortices(void *context, double time, int points,
                      const double point[], const double normal[],
                      double velocity[])
{
    (void)context, (void)normal;
    apply_field(vortices, time, points, point, velocity);
}

//: Draw random waves
enum {
    WAVES = 12
};

/// A random number from -1 to 1, by hashing.
static double random_of(unsigned wave, unsigned which)
{
    unsigned bits = wave * 2654435761U + which * 2246822519U + 374761393U;
    for (int i = 0; i < 3; i++) {
        bits ^= bits >> 15;
        bits *= 2246822519U;
    }
    return 2 * ((bits ^ bits >> 13) / 4294967296.0) - 1;
}

static tf_triple random_triple(unsigned wave, unsigned first)
{
    return (tf_triple){{random_of(wave, first), random_of(wave, first + 1),
                        random_of(wave, first + 2)}};
}

//: Add up waves
/// The curl of cos(k x + w t + p) a is a x k times a sine.
static tf_triple turbulence(double time, tf_triple at)
{
    tf_triple sum = {{0}};
    for (unsigned i = 0; i < WAVES; i++) {
        tf_triple k = tf_triple_unit(random_triple(i, 0));
        double number = 2 * pi * (1 + i % 3);
        double phase = number * tf_triple_dot(k, at) +
                       2 * random_of(i, 3) * time + 4 * random_of(i, 4);
        tf_triple across = tf_triple_cross(random_triple(i, 5), k);
        sum = tf_triple_sum(sum, 0.1 / (1 + i % 3) * sin(phase), across);
    }
    return sum;
}

//: Stir by turbulence
void tf_flow_turbulence(void *context, double time, int points,
                        const double point[], const double normal[],
                        double velocity[])
{
    (void)context, (void)normal;
    apply_field(turbulence, time, points, point, velocity);
}

//: Whirl
static tf_triple whirl(double time, tf_triple at)
{
    (void)time;
    const double speed = 3, width = 0.25;
    double square = at.x[0] * at.x[0] + at.x[2] * at.x[2];
    double turn = speed * exp(-square / (width * width));
    return (tf_triple){{turn * at.x[2], 0, -turn * at.x[0]}};
}

void tf_flow_whirl(void *context, double time, int points, const double point[],
                   const double normal[], double velocity[])
{
    (void)context, (void)normal;
    apply_field(whirl, time, points, point, velocity);
}

//: Grow
void tf_flow_growth(void *context, double time, int points,
                    const double point[], const double normal[],
                    double velocity[])
{
    (void)context, (void)time, (void)point;
    const double speed = 0.1;
    for (int i = 0; i < 3 * points; i++)
        velocity[i] = speed * normal[i];
}
