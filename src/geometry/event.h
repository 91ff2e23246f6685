//: Declare events and worldlines
#pragma once

#include "geometry/vector.h"

enum {
    TF_NO_INDEX = -1 ///< the index of a vertex that belongs to no mesh
};

/// A point of space-time at an end of the time step: (x[0..axes-1], t).  In
/// the plane x[2] is not read.  Any one unit of length; time counts steps.
typedef struct tf_event {
    double x[TF_AXES]; ///< finite
    int t;             ///< 0 or 1
    int vertex;        ///< the global index of the vertex, or TF_NO_INDEX
} tf_event;

/// The straight path of a vertex, from at[0] (t = 0) to at[1] (t = 1).
typedef struct tf_worldline {
    tf_event at[2];
} tf_worldline;

//: Declare how to make a worldline
/// The worldline of a vertex without index that moves from `start` to `end`,
/// both of `axes` coordinates, axes = 2 or 3.
tf_worldline tf_worldline_between(int axes, const double start[],
                                  const double end[]);

/// Gives a worldline the global index of its vertex, 0 or more: in a mesh, its
/// place in the list of vertices.
void tf_worldline_set_vertex(tf_worldline *line, int vertex);
