// From space-time to the world of a picture, for all figures.
#ifndef FIG_WORLDS_H
#define FIG_WORLDS_H

#include "geometry/sweep.h"
#include "query/contact.h"
#include "renderer/scene.h"

/// An event of plane space-time: x and y lie level, t is up.
tf_vector fig_world_of_event(const tf_event *event);

/// The corners of a swept simplex of plane space-time, `simplex->count` of
/// them.
void fig_world_of_simplex(const tf_simplex *simplex, tf_vector world[]);

/// Where in the step a contact is, the middle of its interval; -1 if there is
/// none.
double fig_toi(const tf_contact *contact);

/// Draw plane space at t = 0 and at t = 1, from (0, 0) to (width, depth), in
/// square cells.
void fig_world_floors(fig_scene *scene, double width, double depth,
                      double cell);

/// Draw an edge of plane space-time as it is at t = 0 and at t = 1.
void fig_world_ends(fig_scene *scene, const tf_worldline edge[2]);

/// The place of a vertex at the time t, 0 to 1, in space with `axes` axes; the
/// coordinates beyond are 0.
tf_vector fig_worldline_place(const tf_worldline *worldline, int axes,
                              double t);

enum {
    FIG_SLICE_CORNERS = 4
};

/// What a swept simplex is at one time: a point, a segment, a triangle or a
/// parallelogram, its corners around it in the sense of the element's
/// vertices.  At t = 0 and t = 1 some of them coincide.
typedef struct fig_slice {
    int count;
    tf_vector corner[FIG_SLICE_CORNERS]; ///< coordinates beyond `axes` are 0
} fig_slice;

/// Cut a swept simplex of space with `axes` axes at the time t, 0 to 1.
fig_slice fig_slice_of(const tf_simplex *simplex, int axes, double t);

/// An edge of plane space-time as its sweep has it at the time t, 0 to 1: its
/// first end, the crease and its second end, as world points.
void fig_world_of_edge(const tf_worldline edge[2], double t,
                       tf_vector world[3]);

/// Draw a moving triangle of space as its sweep has it at the time t, 0 to 1:
/// bent, its border thick and its creases thin.
void fig_world_bent(fig_scene *scene, const tf_worldline corner[3], double t,
                    fig_role role);

#endif
