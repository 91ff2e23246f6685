// Where labels go: near their anchors, inside the page, clear of each other
// and of what they should not hide.
#ifndef FIG_RENDERER_PLACEMENT_H
#define FIG_RENDERER_PLACEMENT_H

#include "renderer/box.h"

#include <stdbool.h>

/// What a label should not cover: all within `radius` of a segment.
typedef struct fig_obstacle {
    fig_point from, to;
    double radius;
    double weight; ///< how bad it is to cover it, for each point of length
} fig_obstacle;

/// A label to be placed.
typedef struct fig_wish {
    fig_point anchor;
    double width, height;
    bool any_side;
    double direction;     ///< radians, counterclockwise from the right as seen
    double gap;           ///< from the anchor to the label's box
    double reach;         ///< how much farther off it may stand
    double distance_cost; ///< of each point of that, in the unit of weights
} fig_wish;

/// Choose a box for each wish.  Boxes lie in `page`; they are disjoint from
/// each other and from the `taken` boxes wherever the candidates allow it.
/// The same input gives the same boxes.  False if there is no memory.
bool fig_place(fig_box page, int wishes, const fig_wish wish[], int taken_count,
               const fig_box taken[], int obstacles,
               const fig_obstacle obstacle[], fig_box placed[]);

#endif
