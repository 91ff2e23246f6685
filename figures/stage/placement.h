// Where labels go: near their anchors, inside the page, clear of each other
// and of what they should not hide.
#ifndef TF_STAGE_PLACEMENT_H
#define TF_STAGE_PLACEMENT_H

#include "stage/camera.h"

#include <stdbool.h>

/// What a label should not cover: all within `radius` of a segment.
typedef struct tf_obstacle {
    double from[2], to[2];
    double radius;
    double weight; ///< how bad it is to cover it, for each point of length
} tf_obstacle;

/// A label to be placed.
typedef struct tf_wish {
    double anchor[2];
    double width, height;
    bool any_side;
    double direction;     ///< radians, counterclockwise from the right as seen
    double gap;           ///< from the anchor to the label's box
    double reach;         ///< how much farther off it may stand
    double distance_cost; ///< of each point of that, in the unit of weights
} tf_wish;

/// Choose a box for each wish.  Boxes lie in `page`; they are disjoint from
/// each other and from the `taken` boxes wherever the candidates allow it.
/// The same input gives the same boxes.  False if there is no memory.
bool tf_place(tf_box page, int wishes, const tf_wish wish[], int taken_count,
              const tf_box taken[], int obstacles, const tf_obstacle obstacle[],
              tf_box placed[]);

/// The area that two boxes share.
double tf_box_overlap(const tf_box *a, const tf_box *b);

#endif
