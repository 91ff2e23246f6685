//: Hold a step that is being resolved
#pragma once

#include <stdbool.h>

/// A step that is being resolved: positions are `axes` numbers a vertex.
typedef struct tf_step {
    int axes, vertices;
    const double *start, *proposed;
    const double *inverse_mass;
    double *end;   ///< so far
    bool *changed; ///< vertices that have moved since contacts were looked for
} tf_step;

//: Declare how a step is changed
/// The displacement of a vertex that ends at end[0] to end[axes - 1]; in the
/// plane the third component is 0.
void tf_step_displacement(const tf_step *step, int vertex, const double end[],
                          double displacement[3]);

/// Ends a vertex at `base` plus what `displacement` has more than one to `base`:
/// exactly there if it has nothing more.  Leaves it where it is if the sum is
/// not finite.
void tf_step_place(tf_step *step, int vertex, const double base[],
                   const double displacement[]);
