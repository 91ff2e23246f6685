//: Change a step
#include "response/step.h"

#include <math.h>
#include <stddef.h>

tf_vector tf_step_displacement(const tf_step *step, int vertex,
                               const double end[])
{
    const double *start = step->start + (ptrdiff_t)step->axes * vertex;
    tf_vector displacement = {{0}};
    for (int k = 0; k < step->axes; k++)
        displacement.x[k] = end[k] - start[k];
    return displacement;
}

void tf_step_move(tf_step *step, int vertex, const double base[],
                  const double displacement[])
{
    tf_vector until_now = tf_step_displacement(step, vertex, base), to;
    for (int k = 0; k < step->axes; k++) {
        // Where nothing is added, -0 must not become +0.
        to.x[k] = displacement[k] == until_now.x[k]
                      ? base[k]
                      : base[k] + (displacement[k] - until_now.x[k]);
        if (!isfinite(to.x[k]))
            return;
    }
    double *end = step->end + (ptrdiff_t)step->axes * vertex;
    for (int k = 0; k < step->axes; k++)
        end[k] = to.x[k];
}
