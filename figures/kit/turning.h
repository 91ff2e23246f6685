// A tetrahedron one of whose corners moves to the other side of the opposite
// triangle.
#ifndef FIG_TURNING_H
#define FIG_TURNING_H

#include "renderer/figure.h"

/// Where the corner ends, when it is in the plane of the opposite triangle, and
/// where something meets then; one place of several.
typedef struct fig_turning {
    fig_camera camera;
    double end[3], time, meeting[3];
    const char *name; ///< of what meets
} fig_turning;

/// Draws the tetrahedron at three times, or one frame of a film.
void fig_turning_draw(fig_page *page, FILE *numbers,
                      const fig_turning *turning);

#endif
