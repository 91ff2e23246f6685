// Surfaces in the course of their remeshing.
#ifndef FIG_REMESHED_H
#define FIG_REMESHED_H

#include "kit/meshes.h"
#include "remesh/remesh.h"
#include "renderer/scene.h"

enum {
    FIG_REMESH_ROUNDS = 10, ///< at most
    FIG_REMESH_STAGES = 16 * FIG_REMESH_ROUNDS
};

/// What was done.
typedef struct fig_remeshing {
    int stages; ///< the first is the surface before; each pass makes another
    fig_some_mesh stage[FIG_REMESH_STAGES + 1];
    tf_remesh_report report[FIG_REMESH_ROUNDS]; ///< up to the end of a round
} fig_remeshing;

/// A square plate with a round hole, of needles and slivers.
fig_some_mesh fig_plate_with_hole(int around);

/// A sheet that is rolled up about the z axis, with gaps between its layers.
fig_some_mesh fig_roll_of_sheet(double radius, double gap, double turns,
                                double edge);

/// Remeshes as the library does; without its tests for safety if `tangled`.
void fig_remesh(const fig_some_mesh *mesh, double edge, int rounds,
                bool tangled, fig_remeshing *remeshing);
void fig_remeshing_free(fig_remeshing *remeshing);

/// How many operations of a kind were done, and refused by a test.
double fig_remesh_done(const tf_remesh_report *report, tf_operation operation);
double fig_remesh_refused(const tf_remesh_report *report, tf_outcome outcome);
double fig_remesh_tried(const tf_remesh_report *report);

/// The least angle of the triangles, in degrees.
double fig_least_angle(const fig_some_mesh *mesh);

void fig_draw_triangles(fig_scene *scene, const fig_some_mesh *mesh,
                        fig_paint paint);

#endif
