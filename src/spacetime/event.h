//: Declare events and worldlines
#ifndef TF_SPACETIME_EVENT_H
#define TF_SPACETIME_EVENT_H

enum {
    TF_AXES = 3
}; ///< the most axes of space

/// A point of space-time at an end of the time step: (x[0..axes-1], t).  In
/// the plane x[2] is not read.  Any one unit of length; time counts steps.
typedef struct tf_event {
    double x[TF_AXES]; ///< finite
    int t;             ///< 0 or 1
    int vertex;        ///< the global index of the vertex; 0 if there is none
} tf_event;

/// The straight path of a vertex, from at[0] (t = 0) to at[1] (t = 1).
typedef struct tf_worldline {
    tf_event at[2];
} tf_worldline;

//: Declare how to make a worldline
/// The worldline of a vertex that moves from `start` to `end`, both of `axes`
/// coordinates, axes = 2 or 3.
tf_worldline tf_worldline_between(int axes, const double start[],
                                  const double end[]);

/// Give a worldline the global index of its vertex, 0 or more: in a mesh, its
/// place in the list of vertices.
void tf_worldline_set_vertex(tf_worldline *line, int vertex);

//: Close the events
#endif
