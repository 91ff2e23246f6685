// Where a surface intersects itself: the curves, and what they cut.
#ifndef FIG_CROSSING_CURVES_H
#define FIG_CROSSING_CURVES_H

#include "kit/curve_pieces.h"
#include "kit/meshes.h"

#include <stdbool.h>
#include <stddef.h>

/// What the static check has found in one position, and what follows from it.
typedef struct fig_crossing_curves {
    size_t crossings; ///< how many it lists
    fig_curve_pieces pieces;
    int *part;   ///< of each vertex
    bool *wrong; ///< of each vertex: the library takes its region for wrong
    int parts, regions, wrongs;
} fig_crossing_curves;

/// Check a mesh whose vertices are at x, and find what is cut.
fig_crossing_curves fig_crossing_curves_find(const fig_some_mesh *mesh,
                                             const double x[]);
void fig_crossing_curves_free(fig_crossing_curves *curves);

/// How a mesh is painted: the paint of a triangle, or false: it is not drawn.
typedef bool fig_triangle_paint(const void *context, int triangle,
                                fig_paint *paint);

/// Draw a mesh whose vertices are at x, smoothly lit, with lines of that width
/// along its edges; 0: none.
void fig_draw_smooth_mesh(fig_scene *scene, const fig_some_mesh *mesh,
                          const double x[], double lines,
                          fig_triangle_paint *paint, const void *context);

#endif
