//: Include what candidates need
#include "surface/candidates.h"

#include "base/fail.h"
#include "base/require.h"
#include "surface/detect.h"
#include "surface/filtered_join.h"
#include "surface/surface_memory.h"

#include <stddef.h>
#include <string.h>

//: Keep the candidates of a worker
static bool keep(tf_pair_sink *sink, int count, const tf_candidate pair[])
{
    tf_worker *worker = (tf_worker *)sink;
    const tf_surface *surface = worker->job;
    return tf_worker_goes_on(worker, surface->workers.watch, 0) &&
           tf_worker_add_pairs(worker, count, pair);
}

//: Copy the candidates of a task
typedef struct copy_job {
    tf_workers *workers;
    const tf_task_rows *rows;
    const size_t *place; ///< of the first row of each task
    tf_candidate *to;
} copy_job;

static void copy_rows(void *argument, int task, int number)
{
    const copy_job *job = argument;
    const tf_task_rows *rows = &job->rows[task];
    const tf_candidate *from = job->workers->worker[rows->worker]->row.data;
    tf_worker *own = job->workers->worker[number];
    if (tf_worker_goes_on(own, job->workers->watch, 1) &&
        rows->end > rows->begin)
        memcpy(job->to + job->place[task], from + rows->begin,
               sizeof *from * (rows->end - rows->begin));
}

//: Gather the candidates of all workers
/// Finds all rows, task by task, lent by the surface; false if there is no
/// memory.
static bool gather(tf_surface *surface, int tasks, const tf_task_rows rows[],
                   size_t place[], const tf_parallel *parallel,
                   const tf_candidate **gathered)
{
    // Without threads one worker has them all, in order.
    *gathered = surface->workers.worker[0]->row.data;
    if (!parallel)
        return true;
    size_t all = 0;
    for (int task = 0; task < tasks; task++) {
        place[task] = all;
        all += rows[task].end - rows[task].begin;
    }
    if (!tf_buffer_reserve(&surface->found, all + 1, sizeof(tf_candidate)))
        return false;
    copy_job job = {&surface->workers, rows, place, surface->found.data};
    tf_watch_stage(surface->workers.watch, "candidates", (size_t)tasks);
    tf_parallel_for_each(parallel, tasks, copy_rows, &job);
    *gathered = job.to;
    return true;
}

//: Join all elements
/// Joins the vertices with the elements that they may touch, then the edges
/// with each other; returns how many rows the first of these gave.
static size_t join_all(tf_surface *surface, tf_task_rows rows[],
                       const tf_parallel *parallel)
{
    tf_surface_join(surface, 1, surface->axes, keep, rows, parallel);
    size_t points = tf_workers_rows(&surface->workers);
    if (surface->axes == 3)
        tf_surface_join(surface, 2, 2, keep,
                        rows + tf_join_tasks(&surface->vertex_tree), parallel);
    return points;
}

//: List all candidates
static tf_status list_all(tf_surface *surface, const tf_parallel *parallel,
                          tf_candidates *found)
{
    int tasks = tf_join_tasks(&surface->vertex_tree);
    if (surface->axes == 3)
        tasks += tf_join_tasks(&surface->edge_tree);
    if (!tf_buffer_reserve(&surface->task_rows, (size_t)tasks,
                           sizeof(tf_task_rows)) ||
        !tf_buffer_reserve(&surface->task_places, (size_t)tasks,
                           sizeof(size_t)))
        return TF_OUT_OF_MEMORY;
    tf_task_rows *rows = surface->task_rows.data;
    tf_candidates all = {.point_count = join_all(surface, rows, parallel)};
    tf_status status = tf_workers_status(&surface->workers);
    if (status != TF_OK)
        return status;
    all.edge_count = tf_workers_rows(&surface->workers) - all.point_count;
    if (!gather(surface, tasks, rows, surface->task_places.data, parallel,
                &all.points))
        return TF_OUT_OF_MEMORY;
    all.edges = all.points ? all.points + all.point_count : NULL;
    status = tf_workers_status(&surface->workers);
    if (status == TF_OK)
        *found = all;
    return status;
}

//: Find the candidates of a step
static tf_status find(tf_surface *surface, const tf_motion *motion,
                      const tf_parallel *parallel, tf_candidates *found,
                      tf_error *error)
{
    tf_status status = tf_parallel_check(parallel, error);
    if (status == TF_OK)
        status = tf_surface_move(surface, motion, false, parallel, error);
    if (status != TF_OK)
        return status;
    bool good = tf_workers_begin(&surface->workers,
                                 tf_parallel_workers(parallel), surface);
    return tf_fail(error, good ? list_all(surface, parallel, found)
                               : TF_OUT_OF_MEMORY);
}

tf_status tf_surface_candidates(tf_surface *surface, const tf_motion *motion,
                                const tf_detect_options *options,
                                tf_candidates *found, tf_error *error)
{
    TF_REQUIRE(surface && motion && found);
    tf_detect_options own;
    tf_status status = tf_detect_options_read(&own, options, error);
    if (status != TF_OK)
        return status;
    tf_watch watch, *outer = tf_workers_watch(&surface->workers, &watch,
                                              own.progress, own.context);
    status = tf_surface_enter_zones(surface, own.zone)
                 ? find(surface, motion, own.parallel, found, error)
                 : tf_fail(error, TF_OUT_OF_MEMORY);
    if (own.zone)
        tf_surface_leave_zones(surface);
    surface->workers.watch = outer;
    return status;
}
