//: Include what the sweep needs
#include "geometry/sweep.h"

#include "base/require.h"

//: Make one step of the staircase
static tf_simplex staircase_step(int vertices, const tf_worldline element[],
                                 int pivot)
{
    tf_simplex step = {.pivot = pivot};
    for (int i = 0; i <= pivot; i++)
        step.event[step.count++] = &element[i].at[0];
    for (int i = pivot; i < vertices; i++)
        step.event[step.count++] = &element[i].at[1];
    return step;
}

//: Sweep an element
void tf_sweep(int vertices, const tf_worldline element[], tf_simplex sweep[])
{
    TF_REQUIRE(vertices >= 1 && vertices <= TF_VERTICES);
    for (int i = 0; i < vertices; i++)
        sweep[i] = staircase_step(vertices, element, vertices - 1 - i);
}
