// The picture of a surface, at rest or in a step.
#ifndef FIG_DRAW_SURFACE_PICTURE_H
#define FIG_DRAW_SURFACE_PICTURE_H

#include "draw/drawing.h"
#include "draw/surface_marks.h"
#include "draw/surface_tangle.h"
#include "draw/surface_view.h"
#include "kit/surface_shape.h"

/// A surface to be drawn.
typedef struct fig_shown_surface {
    fig_shape shape;
    bool steps;      ///< there is a step; otherwise the surface is at rest
    bool marked;     ///< there are marks
    fig_marks marks; ///< of a step if there is one
    bool crosses;    ///< curves and zones are shown in place of marked elements
    fig_tangled tangled;
    fig_motion motion;
    double time;       ///< of a picture that is no film
    fig_camera camera; ///< fitted
    double scale;      ///< points of the page for the side of the box
    int outline_count;
    tf_vector outline[FIG_OUTLINE];
} fig_shown_surface;

/// Choose the time of a picture if `time` < 0, and the view.
void fig_shown_surface_look(fig_shown_surface *shown, double time);

/// Its drawing, which borrows it.
fig_drawing fig_surface_drawing(const fig_shown_surface *shown);

#endif
