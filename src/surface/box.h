//: Declare boxes
#pragma once

#include "base/status.h"
#include "geometry/vector.h"
#include "query/motion.h"
#include "surface/tasks.h"

#include <stdbool.h>

enum {
    TF_SIDES = 2 * TF_AXES, ///< coordinates of a path: its start, then its end
    TF_PATH_ROOM = 8        ///< as many as two vectors hold
};

/// Where a vertex starts and ends, in the coordinates of a frame.  Those from
/// TF_SIDES on are 0.
typedef struct tf_path {
    float at[TF_PATH_ROOM];
} tf_path;

/// Two closed boxes with sides along the axes, in the coordinates of a frame:
/// around where things start, and around where they end.
typedef struct tf_box {
    float low[TF_SIDES], high[TF_SIDES];
} tf_box;

/// The box that holds nothing: the union with it changes no box, and it
/// overlaps none.
extern const tf_box tf_box_empty;

//: Declare frames
/// The least and greatest coordinates on each side.
typedef struct tf_extent {
    double low[TF_SIDES], high[TF_SIDES];
} tf_extent;

/// Coordinates for boxes: x - center, times a power of two that brings the
/// largest near 1, rounded to float.  Each of these steps keeps the order of
/// numbers (x <= y becomes x' <= y'), so elements that overlap along an axis
/// still do, though all is rounded to nearest.  Starts are compared with starts
/// alone, and ends with ends; so each end of the step has a center of its own,
/// and a motion that all vertices have in common makes no difference.
typedef struct tf_frame {
    int axes;
    double center[TF_SIDES];
    double scale;
    tf_extent extent; ///< of all paths
    tf_box whole;     ///< their union
} tf_frame;

/// The frame of all vertices of a motion.  Returns TF_NOT_FINITE, and the first
/// such vertex in `*bad`, if a coordinate is infinite or NaN.
tf_status tf_frame_of(int axes, const tf_motion *motion,
                      const tf_parallel *parallel, tf_frame *frame, int *bad);

/// Turns a frame into one for swept boxes, with the same map for both ends.
void tf_frame_sweep(tf_frame *frame);

/// The coordinate in a frame that a coordinate of space has at one side.
static inline float tf_frame_coordinate(const tf_frame *frame, int side,
                                        double x)
{
    return (float)((x - frame->center[side]) * frame->scale);
}

/// The path of a vertex.
tf_path tf_vertex_path(const tf_frame *frame, const tf_motion *motion,
                       int vertex);

/// The paths of all vertices.
void tf_vertex_paths(const tf_frame *frame, const tf_motion *motion,
                     const tf_parallel *parallel, tf_path path[]);
