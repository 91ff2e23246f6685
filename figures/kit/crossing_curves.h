// Where a surface intersects itself: the curves, and what they cut.
#ifndef FIG_CROSSING_CURVES_H
#define FIG_CROSSING_CURVES_H

#include "kit/meshes.h"
#include "renderer/scene.h"
#include "surface/check.h"

#include <stdbool.h>
#include <stddef.h>

/// A piece of a curve: where two triangles intersect.
typedef struct fig_curve_piece {
    tf_vector at[2];
    int triangle[2]; ///< of the mesh
} fig_curve_piece;

/// What the static check has found in one position, and what follows from it.
typedef struct fig_crossing_curves {
    size_t crossings; ///< how many it lists
    int pieces;
    fig_curve_piece *piece;
    bool *crosses; ///< of each triangle: it intersects another one
    int *part;     ///< of each vertex
    bool *wrong;   ///< of each vertex: the library takes its region for wrong
    int parts, regions, wrongs;
} fig_crossing_curves;

/// Check a mesh whose vertices are at x, and find what is cut.
fig_crossing_curves fig_crossing_curves_find(const fig_some_mesh *mesh,
                                             const double x[]);
void fig_crossing_curves_free(fig_crossing_curves *curves);

/// Draw the curves as tubes.
void fig_crossing_curves_draw(fig_scene *scene,
                              const fig_crossing_curves *curves, double width);

/// How a mesh is painted: the paint of a triangle, or false: it is not drawn.
typedef bool fig_triangle_paint(const void *context, int triangle,
                                fig_paint *paint);

/// Draw a mesh whose vertices are at x, smoothly lit, with lines of that width
/// along its edges; 0: none.
void fig_draw_smooth_mesh(fig_scene *scene, const fig_some_mesh *mesh,
                          const double x[], double lines,
                          fig_triangle_paint *paint, const void *context);

#endif
