// Rectangles of the page.
#ifndef FIG_RENDERER_BOX_H
#define FIG_RENDERER_BOX_H

#include "renderer/vector.h"

#include <stdbool.h>

/// A rectangle in points; x to the right and y down, (x, y) its upper left.
typedef struct fig_box {
    double x, y, width, height;
} fig_box;

/// The area that two boxes share.
double fig_box_overlap(const fig_box *a, const fig_box *b);

/// Clip a segment to a box, border and all: what is left of it reaches from
/// part[0] to part[1], in 0..1 along the segment.  False if nothing is left.
bool fig_box_clip(const fig_box *box, fig_point from, fig_point to,
                  double part[2]);

#endif
