//: Include what the sweep needs
#include "geometry/sweep.h"

#include "base/require.h"

//: Make one step of the staircase
static void set_step(int vertices, const tf_worldline element[], int pivot,
                     tf_simplex *step)
{
    step->pivot = pivot;
    step->count = vertices + 1;
    for (int i = 0; i <= pivot; i++)
        step->event[i] = &element[i].at[0];
    for (int i = pivot; i < vertices; i++)
        step->event[i + 1] = &element[i].at[1];
}

//: Sweep an element
void tf_sweep(int vertices, const tf_worldline element[], tf_simplex sweep[])
{
    TF_REQUIRE(vertices >= 1 && vertices <= TF_VERTICES);
    for (int i = 0; i < vertices; i++)
        set_step(vertices, element, vertices - 1 - i, &sweep[i]);
}
