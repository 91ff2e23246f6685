//: Declare boxes
#pragma once

#include "base/status.h"
#include "query/motion.h"
#include "surface/tasks.h"

#include <stdbool.h>

/// A closed box with sides along the axes, in the coordinates of a frame.
typedef struct tf_box {
    float low[3], high[3]; ///< in the plane the third is 0
} tf_box;

/// The box that holds nothing: the union with it changes no box, and it
/// overlaps none.
extern const tf_box tf_box_empty;

static inline tf_box tf_box_union(tf_box a, tf_box b)
{
    for (int k = 0; k < 3; k++) {
        a.low[k] = b.low[k] < a.low[k] ? b.low[k] : a.low[k];
        a.high[k] = b.high[k] > a.high[k] ? b.high[k] : a.high[k];
    }
    return a;
}

//: Declare frames
/// Coordinates for boxes: x - center, times a power of two that brings the
/// largest near 1, rounded to float.  Each of these steps keeps the order of
/// numbers (x <= y becomes x' <= y'), so boxes that overlap still do, though
/// all is rounded to nearest.
typedef struct tf_frame {
    int axes;
    double center[3];
    double scale;
    tf_box whole; ///< the union of the boxes of all paths
} tf_frame;

/// The frame of all vertices of a motion.  Returns TF_NOT_FINITE, and the first
/// such vertex in `*bad`, if a coordinate is infinite or NaN.
tf_status tf_frame_of(int axes, const tf_motion *motion,
                      const tf_parallel *parallel, tf_frame *frame, int *bad);

/// The coordinate of a box in a frame that a coordinate of space has.  Ends may
/// move far out of the frame after it was found: no coordinate is beyond those of
/// the empty box.
static inline float tf_frame_coordinate(const tf_frame *frame, int axis,
                                        double x)
{
    const double most = 0x1p100;
    double at = (x - frame->center[axis]) * frame->scale;
    return (float)(at > most ? most : at < -most ? -most : at);
}

/// The box of the path of a vertex, from start to end.
tf_box tf_vertex_box(const tf_frame *frame, const tf_motion *motion,
                     int vertex);

/// The boxes of the paths of all vertices.
void tf_vertex_boxes(const tf_frame *frame, const tf_motion *motion,
                     const tf_parallel *parallel, tf_box box[]);
