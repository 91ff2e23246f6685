// From where a surface is seen best.
#ifndef FIG_DRAW_SURFACE_VIEW_H
#define FIG_DRAW_SURFACE_VIEW_H

#include "draw/surface_marks.h"
#include "renderer/camera.h"

/// Choose where to look from: a three-quarter view that shows as much as it can
/// of the surface at the time t, moved in straight lines, and of the spots of
/// marks, which may be NULL.
fig_camera fig_surface_camera(const fig_shape *shape, const fig_marks *marks,
                              double t);

enum {
    FIG_OUTLINE = 4000
}; ///< the most points of an outline

/// Points that reach as far, in any direction, as all places of the surface in
/// the step do, but for a hundredth of its size.  Returns how many.
int fig_surface_outline(const fig_shape *shape, tf_vector point[FIG_OUTLINE]);

#endif
