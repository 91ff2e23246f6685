//: Include what velocity fields need
#include "simulate/flow_fields.h"

#include "geometry/vector.h"

#include <math.h>
#include <string.h>

static const double pi = 3.141592653589793;

//: Apply a field point by point
void tf_field_apply(void *context, double time, int points,
                    const double point[], const double normal[],
                    double velocity[])
{
    tf_velocity_field *const *field = context;
    for (int i = 0; i < points; i++) {
        tf_vector v =
            (*field)(time, tf_vector_at(point, i), tf_vector_at(normal, i));
        memcpy(velocity + 3 * (ptrdiff_t)i, v.x, sizeof v.x);
    }
}

//: Splash
/// What comes along the axis must go outwards: v = -f at x, and r f' / 2 at the
/// distance r from the axis.
tf_vector tf_splash(double time, tf_vector at, tf_vector normal)
{
    (void)normal;
    const double speed = 0.25 * cos(pi * time / 3), width = 0.1;
    double slowing = tanh(at.x[0] / width);
    double out = speed / width * (1 - slowing * slowing) / 2;
    return (tf_vector){{-speed * slowing, out * at.x[1], out * at.x[2]}};
}

//: Squeeze
/// As for a splash, with f' = -2 exp(-(x / width)^2).
tf_vector tf_squeeze(double time, tf_vector at, tf_vector normal)
{
    (void)time, (void)normal;
    const double speed = 2, width = 0.12;
    double near = speed * exp(-at.x[0] * at.x[0] / (width * width));
    double along = speed * width * sqrt(pi) * erf(at.x[0] / width);
    return (tf_vector){{along, -near * at.x[1], -near * at.x[2]}};
}

//: Stir by vortices
tf_vector tf_vortices(double time, tf_vector at, tf_vector normal)
{
    (void)normal;
    double once[3], twice[3], now = cos(pi * time / 3);
    for (int k = 0; k < 3; k++) {
        once[k] = sin(pi * at.x[k]) * sin(pi * at.x[k]);
        twice[k] = sin(2 * pi * at.x[k]);
    }
    return (tf_vector){{2 * now * once[0] * twice[1] * twice[2],
                        -now * twice[0] * once[1] * twice[2],
                        -now * twice[0] * twice[1] * once[2]}};
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

static tf_vector random_vector(unsigned wave, unsigned first)
{
    return (tf_vector){{random_of(wave, first), random_of(wave, first + 1),
                        random_of(wave, first + 2)}};
}

//: Stir by turbulence
/// The curl of cos(k x + w t + p) a is a x k times a sine.
tf_vector tf_turbulence(double time, tf_vector at, tf_vector normal)
{
    (void)normal;
    tf_vector sum = {{0}};
    for (unsigned i = 0; i < WAVES; i++) {
        tf_vector k = tf_vector_unit(random_vector(i, 0));
        double number = 2 * pi * (1 + i % 3);
        double phase = number * tf_vector_dot(k, at) +
                       2 * random_of(i, 3) * time + 4 * random_of(i, 4);
        tf_vector across = tf_vector_cross(random_vector(i, 5), k);
        sum = tf_vector_sum(sum, 0.1 / (1 + i % 3) * sin(phase), across);
    }
    return sum;
}

//: Whirl
tf_vector tf_whirl(double time, tf_vector at, tf_vector normal)
{
    (void)time, (void)normal;
    const double speed = 3, width = 0.25;
    double square = at.x[0] * at.x[0] + at.x[2] * at.x[2];
    double turn = speed * exp(-square / (width * width));
    return (tf_vector){{turn * at.x[2], 0, -turn * at.x[0]}};
}

//: Grow
tf_vector tf_growth(double time, tf_vector at, tf_vector normal)
{
    (void)time, (void)at;
    return tf_vector_scaled(0.1, normal);
}
