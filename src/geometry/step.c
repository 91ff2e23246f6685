//: Change a step
#include "geometry/step.h"

#include <math.h>
#include <stddef.h>

tf_vector tf_step_position(const tf_step *step, int vertex,
                           const double position[])
{
    const double *x = position + (ptrdiff_t)step->axes * vertex;
    return (tf_vector){{x[0], x[1], step->axes == 3 ? x[2] : 0}};
}

tf_vector tf_step_displacement(const tf_step *step, int vertex,
                               const double end[])
{
    return tf_vector_difference(tf_step_position(step, vertex, end),
                                tf_step_position(step, vertex, step->start));
}

double tf_step_part(double from, double to, double fraction)
{
    // Half of it twice, because their difference may overflow.
    double half = (to / 2 - from / 2) * fraction;
    return half == 0 ? from : from + half + half;
}

void tf_step_move(const tf_step *step, int vertex, const double base[],
                  const double displacement[], double end[])
{
    tf_vector to = tf_step_position(step, vertex, base);
    tf_vector until_now = tf_step_displacement(step, vertex, base);
    end += (ptrdiff_t)step->axes * vertex;
    for (int k = 0; k < step->axes; k++) {
        // Where nothing is added, -0 must not become +0.
        if (displacement[k] != until_now.x[k])
            to.x[k] += displacement[k] - until_now.x[k];
        if (!isfinite(to.x[k]))
            return;
    }
    for (int k = 0; k < step->axes; k++)
        end[k] = to.x[k];
}
