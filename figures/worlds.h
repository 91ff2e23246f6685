// From space-time to the world of a picture, for all figures.
#ifndef TF_FIGURES_WORLDS_H
#define TF_FIGURES_WORLDS_H

#include "spacetime/sweep.h"
#include "stage/scene.h"

/// An event of plane space-time: x and y lie level, t is up.
void tf_world_of_event(const tf_event *event, double world[3]);

/// The corners of a swept simplex of plane space-time, `simplex->count` of
/// them.
void tf_world_of_simplex(const tf_simplex *simplex, double world[][3]);

/// Draw plane space at t = 0 and at t = 1, from (0, 0) to (width, depth), in
/// square cells.
void tf_world_floors(tf_scene *scene, double width, double depth, double cell);

/// The place of a vertex at the time t, 0 to 1, in space with `axes` axes; the
/// coordinates beyond are 0.
void tf_worldline_place(const tf_worldline *worldline, int axes, double t,
                        double place[3]);

enum {
    TF_SLICE_CORNERS = 4
};

/// What a swept simplex is at one time: a point, a segment, a triangle or a
/// parallelogram, its corners around it in the sense of the element's
/// vertices.  At t = 0 and t = 1 some of them coincide.
typedef struct tf_slice {
    int count;
    double corner[TF_SLICE_CORNERS][3]; ///< coordinates beyond `axes` are 0
} tf_slice;

/// Cut a swept simplex of space with `axes` axes at the time t, 0 to 1.
tf_slice tf_slice_of(const tf_simplex *simplex, int axes, double t);

/// An edge of plane space-time as its sweep has it at the time t, 0 to 1: its
/// first end, the crease and its second end, as world points.
void tf_world_of_edge(const tf_worldline edge[2], double t, double world[3][3]);

#endif
