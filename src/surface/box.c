//: Include what boxes need
#include "surface/box.h"

#include <math.h>
#include <stddef.h>

const tf_box tf_box_empty = {
    {INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY},
    {-INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY}};

//: Find the extent of a motion
static tf_extent no_extent(void)
{
    tf_extent all;
    for (int side = 0; side < TF_SIDES; side++) {
        all.low[side] = INFINITY;
        all.high[side] = -INFINITY;
    }
    return all;
}

/// Takes in the coordinates of one vertex, on the sides from `first` on; false if
/// one of them is not finite.
static bool take_in(tf_extent *all, int first, int axes, const double *x)
{
    double *low = all->low + first, *high = all->high + first;
    bool finite = true;
    for (int k = 0; k < axes; k++) {
        finite &= isfinite(x[k]) != 0;
        low[k] = x[k] < low[k] ? x[k] : low[k];
        high[k] = x[k] > high[k] ? x[k] : high[k];
    }
    return finite;
}

/// Gives both ends the same extent: that of all that is swept.
static void sweep(tf_extent *all)
{
    take_in(all, 0, TF_AXES, all->low + TF_AXES);
    take_in(all, 0, TF_AXES, all->high + TF_AXES);
    for (int k = 0; k < TF_AXES; k++) {
        all->low[TF_AXES + k] = all->low[k];
        all->high[TF_AXES + k] = all->high[k];
    }
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

static tf_frame frame_of(int axes, const tf_extent *all)
{
    tf_frame frame = {.axes = axes, .extent = *all};
    double size = 0;
    for (int side = 0; side < TF_SIDES; side++) {
        if (side % TF_AXES >= axes)
            continue;
        // Halves first: the sum and the difference may overflow.
        frame.center[side] = all->low[side] / 2 + all->high[side] / 2;
        size = fmax(size, all->high[side] / 2 - all->low[side] / 2);
    }
    frame.scale = scale_of(size);
    for (int side = 0; side < TF_SIDES; side++) {
        if (side % TF_AXES >= axes)
            continue;
        frame.whole.low[side] =
            tf_frame_coordinate(&frame, side, all->low[side]);
        frame.whole.high[side] =
            tf_frame_coordinate(&frame, side, all->high[side]);
    }
    return frame;
}

void tf_frame_sweep(tf_frame *frame)
{
    tf_extent all = frame->extent;
    sweep(&all);
    *frame = frame_of(frame->axes, &all);
}

//: Find the path of a vertex
tf_path tf_vertex_path(const tf_frame *frame, const tf_motion *motion,
                       int vertex)
{
    tf_path path = {{0}};
    for (int k = 0; k < frame->axes; k++) {
        ptrdiff_t place = (ptrdiff_t)frame->axes * vertex + k;
        path.at[k] = tf_frame_coordinate(frame, k, motion->start[place]);
        path.at[TF_AXES + k] =
            tf_frame_coordinate(frame, TF_AXES + k, motion->end[place]);
    }
    return path;
}

//: Find the path of each vertex of a part
enum {
    VERTICES = 16384 // a task
};

typedef struct path_job {
    const tf_frame *frame;
    const tf_motion *motion;
    tf_path *path;
} path_job;

static void map_vertices(void *argument, int task, int worker)
{
    const path_job *job = argument;
    tf_range part = tf_range_part(job->motion->vertices, VERTICES, task);
    (void)worker;
    for (int v = part.begin; v < part.end; v++)
        job->path[v] = tf_vertex_path(job->frame, job->motion, v);
}

//: Find the path of each vertex
void tf_vertex_paths(const tf_frame *frame, const tf_motion *motion,
                     const tf_parallel *parallel, tf_path path[])
{
    path_job job = {frame, motion, path};
    tf_parallel_for_each(parallel, tf_range_parts(motion->vertices, VERTICES),
                         map_vertices, &job);
}

//: Find the extent of a part
enum {
    PARTS = 64 // at most
};

typedef struct extent_job {
    int axes;
    const tf_motion *motion;
    int size; ///< of a part, in vertices
    tf_extent extent[PARTS];
    int bad[PARTS]; ///< the first vertex that is not finite, or -1
} extent_job;

static void measure_part(void *argument, int task, int worker)
{
    extent_job *job = argument;
    const tf_motion *motion = job->motion;
    tf_range part = tf_range_part(motion->vertices, job->size, task);
    tf_extent all = no_extent();
    (void)worker;
    job->bad[task] = -1;
    for (int v = part.begin; v < part.end; v++) {
        ptrdiff_t place = (ptrdiff_t)job->axes * v;
        bool start = take_in(&all, 0, job->axes, motion->start + place);
        bool end = take_in(&all, TF_AXES, job->axes, motion->end + place);
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
    tf_extent all = no_extent();
    for (int task = 0; task < tasks; task++) {
        if (job.bad[task] >= 0) {
            *bad = job.bad[task];
            return TF_NOT_FINITE;
        }
        take_in(&all, 0, TF_SIDES, job.extent[task].low);
        take_in(&all, 0, TF_SIDES, job.extent[task].high);
    }
    *frame = frame_of(axes, &all);
    return TF_OK;
}
