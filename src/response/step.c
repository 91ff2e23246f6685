//: Change a step
#include "response/step.h"

#include <math.h>
#include <stddef.h>

void tf_step_displacement(const tf_step *step, int vertex, const double end[],
                          double displacement[3])
{
    const double *start = step->start + (ptrdiff_t)step->axes * vertex;
    for (int k = 0; k < 3; k++)
        displacement[k] = k < step->axes ? end[k] - start[k] : 0;
}

void tf_step_place(tf_step *step, int vertex, const double base[],
                   const double displacement[])
{
    double until_now[3], place[3];
    tf_step_displacement(step, vertex, base, until_now);
    for (int k = 0; k < step->axes; k++) {
        // Where nothing is added, -0 must not become +0.
        place[k] = displacement[k] == until_now[k]
                       ? base[k]
                       : base[k] + (displacement[k] - until_now[k]);
        if (!isfinite(place[k]))
            return;
    }
    double *end = step->end + (ptrdiff_t)step->axes * vertex;
    for (int k = 0; k < step->axes; k++)
        end[k] = place[k];
}
