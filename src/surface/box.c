//: Include what boxes need
#include "surface/box.h"

#include <math.h>
#include <stddef.h>

const tf_box tf_box_empty = {{INFINITY, INFINITY, INFINITY},
                             {-INFINITY, -INFINITY, -INFINITY}};

//: Find the extent of a motion
/// The least and greatest coordinates along each axis.
typedef struct bounds {
    double low[3], high[3];
} bounds;

static const bounds no_bounds = {{INFINITY, INFINITY, INFINITY},
                                 {-INFINITY, -INFINITY, -INFINITY}};

/// Takes in the coordinates of one vertex; false if one of them is not finite.
static bool take_in(bounds *all, int axes, const double *x)
{
    bool finite = true;
    for (int k = 0; k < axes; k++) {
        finite &= isfinite(x[k]) != 0;
        all->low[k] = x[k] < all->low[k] ? x[k] : all->low[k];
        all->high[k] = x[k] > all->high[k] ? x[k] : all->high[k];
    }
    return finite;
}

//: Center and scale
/// The power of two that brings a size near 1, or as near as a double allows
/// for both of them.
static double scale_of(double size)
{
    int exponent = 0;
    if (size > 0)
        frexp(size, &exponent);
    return ldexp(1, exponent < -1000 ? 1000 : -exponent);
}

static tf_frame frame_of(int axes, const bounds *all)
{
    tf_frame frame = {.axes = axes};
    double size = 0;
    for (int k = 0; k < axes; k++) {
        // Halves first: the sum and the difference may overflow.
        frame.center[k] = all->low[k] / 2 + all->high[k] / 2;
        size = fmax(size, all->high[k] / 2 - all->low[k] / 2);
    }
    frame.scale = scale_of(size);
    for (int k = 0; k < axes; k++) {
        frame.whole.low[k] = tf_frame_coordinate(&frame, k, all->low[k]);
        frame.whole.high[k] = tf_frame_coordinate(&frame, k, all->high[k]);
    }
    return frame;
}

//: Put a box around the path of a vertex
tf_box tf_vertex_box(const tf_frame *frame, const tf_motion *motion, int vertex)
{
    tf_box box = {{0}, {0}};
    for (int k = 0; k < frame->axes; k++) {
        ptrdiff_t place = (ptrdiff_t)frame->axes * vertex + k;
        float a = tf_frame_coordinate(frame, k, motion->start[place]);
        float b = tf_frame_coordinate(frame, k, motion->end[place]);
        box.low[k] = a < b ? a : b;
        box.high[k] = a < b ? b : a;
    }
    return box;
}

//: Put a box around the path of each vertex of a part
enum {
    VERTICES = 16384 // a task
};

typedef struct box_job {
    const tf_frame *frame;
    const tf_motion *motion;
    tf_box *box;
} box_job;

static void box_vertices(void *argument, int task, int worker)
{
    const box_job *job = argument;
    tf_range part = tf_range_part(job->motion->vertices, VERTICES, task);
    (void)worker;
    for (int v = part.begin; v < part.end; v++)
        job->box[v] = tf_vertex_box(job->frame, job->motion, v);
}

//: Put a box around the path of each vertex
void tf_vertex_boxes(const tf_frame *frame, const tf_motion *motion,
                     const tf_parallel *parallel, tf_box box[])
{
    box_job job = {frame, motion, box};
    tf_parallel_for_each(parallel, tf_range_parts(motion->vertices, VERTICES),
                         box_vertices, &job);
}

//: Find the extent of a part
enum {
    PARTS = 64 // at most
};

typedef struct extent_job {
    int axes;
    const tf_motion *motion;
    int size; ///< of a part, in vertices
    bounds extent[PARTS];
    int bad[PARTS]; ///< the first vertex that is not finite, or -1
} extent_job;

static void measure_part(void *argument, int task, int worker)
{
    extent_job *job = argument;
    const tf_motion *motion = job->motion;
    tf_range part = tf_range_part(motion->vertices, job->size, task);
    bounds all = no_bounds;
    (void)worker;
    job->bad[task] = -1;
    for (int v = part.begin; v < part.end; v++) {
        ptrdiff_t place = (ptrdiff_t)job->axes * v;
        bool start = take_in(&all, job->axes, motion->start + place);
        bool end = take_in(&all, job->axes, motion->end + place);
        if (!start || !end) {
            job->bad[task] = v;
            return;
        }
    }
    job->extent[task] = all;
}

//: Find the frame of a motion
tf_status tf_frame_of(int axes, const tf_motion *motion,
                      const tf_parallel *parallel, tf_frame *frame, int *bad)
{
    extent_job job = {.axes = axes,
                      .motion = motion,
                      .size = tf_range_size(motion->vertices, PARTS, VERTICES)};
    int tasks = tf_range_parts(motion->vertices, job.size);
    tf_parallel_for_each(parallel, tasks, measure_part, &job);
    bounds all = no_bounds;
    for (int task = 0; task < tasks; task++) {
        if (job.bad[task] >= 0) {
            *bad = job.bad[task];
            return TF_NOT_FINITE;
        }
        take_in(&all, axes, job.extent[task].low);
        take_in(&all, axes, job.extent[task].high);
    }
    *frame = frame_of(axes, &all);
    return TF_OK;
}
