//: Hold a step that is being resolved
#pragma once

#include "base/watch.h"
#include "geometry/vector.h"

/// A step that is being resolved.  Each position is `axes` numbers.
typedef struct tf_step {
    int axes, vertices;
    const double *start, *proposed;
    const double *inverse_mass;
    double *end;          ///< as it is so far
    double *unpushed;     ///< the same without what pushes pairs apart
    unsigned char *flags; ///< what was done with each vertex: tf_vertex_flags
    tf_watch *watch;      ///< over the call; or NULL
} tf_step;

//: Declare how a step is changed
/// The position of a vertex of the step, of an array of positions.  In the plane
/// the third coordinate is 0.
tf_vector tf_step_position(const tf_step *step, int vertex,
                           const double position[]);

/// The displacement of a vertex with these ends of all vertices.
tf_vector tf_step_displacement(const tf_step *step, int vertex,
                               const double end[]);

/// A fraction, from 0 to 1, of the way from one coordinate to another.
double tf_step_part(double from, double to, double fraction);

/// Moves a vertex, in the array `end` of all vertices, to its base, of the bases
/// of all vertices, plus the difference between `displacement` and the
/// displacement that ends at the base; to the base itself if the two are the
/// same.  Leaves the vertex where it is if the sum is not finite.
void tf_step_move(const tf_step *step, int vertex, const double base[],
                  const double displacement[], double end[]);
