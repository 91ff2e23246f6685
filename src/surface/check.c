//: Include what the check needs
#include "surface/check.h"

#include "arithmetic/exact.h"
#include "base/environment.h"
#include "base/require.h"
#include "base/sized.h"
#include "query/apart.h"
#include "query/query.h"
#include "surface/crossing.h"
#include "surface/filtered_join.h"
#include "surface/pair_vertices.h"

#include <stddef.h>

//: Hold a check
typedef struct check_job {
    const tf_surface *surface;
    tf_motion rest;        ///< the surface, at rest for a step
    tf_crossing_kind kind; ///< of crossings that are sought
} check_job;

/// How many vertices the two elements have.
typedef struct shape {
    int first, second;
} shape;

static shape shape_of(tf_crossing_kind kind)
{
    static const shape shapes[] = {
        [TF_EDGE_THROUGH_TRIANGLE] = {2, 3},
        [TF_POINT_ON_TRIANGLE] = {1, 3},
        [TF_EDGE_ON_EDGE] = {2, 2},
    };
    return shapes[kind];
}

//: Name a pair
static tf_crossing crossing_of(const check_job *job, tf_candidate pair)
{
    shape s = shape_of(job->kind);
    tf_crossing row = {job->kind, {-1, -1, -1, -1, -1}};
    tf_pair_vertices(job->surface, s.first, s.second, pair, row.vertex);
    return row;
}

//: Decide whether four vertices at rest touch
/// Whether two elements of four vertices touch.  At rest that is a contact at
/// once; but first of all the four must lie in a plane.
static tf_status touches(const check_job *job, shape s, const int vertex[],
                         const double *const x[], bool *found)
{
    *found = false;
    if (!tf_are_coplanar(x[0], x[1], x[2], x[3]))
        return TF_OK;
    if (!tf_environment_is_ieee())
        return TF_BAD_ENVIRONMENT;
    tf_verdict verdict = TF_APART;
    bool separated = false;
    tf_status status =
        tf_query_verdict(&tf_exact, 3, &job->rest, s.first, vertex, s.second,
                         vertex + s.first, &verdict, &separated);
    *found = verdict == TF_HIT;
    return status;
}

//: Look for a direction that separates a pair at rest
/// Whether a direction certainly separates two elements in space.
static bool are_apart(shape s, const double *const x[])
{
    tf_difference_list list = {.count = 0};
    tf_list_differences(s.first, s.second, x, &list);
    return tf_environment_is_ieee() && tf_certainly_apart(&list);
}

//: Decide whether a pair at rest intersects
static tf_status intersects(const check_job *job, const int vertex[],
                            bool *found)
{
    int axes = job->surface->axes;
    const double *x[5] = {NULL};
    for (int i = 0; i < 5 && vertex[i] >= 0; i++)
        x[i] = job->rest.start + (size_t)axes * (size_t)vertex[i];
    shape s = shape_of(job->kind);
    *found = false;
    if (axes == 3 && are_apart(s, x))
        return TF_OK;
    if (job->kind == TF_EDGE_THROUGH_TRIANGLE)
        *found = tf_edge_crosses_triangle(x[0], x[1], x[2], x[3], x[4]);
    else if (axes == 2)
        *found = tf_edges_cross(x[0], x[1], x[2], x[3]);
    else
        return touches(job, s, vertex, x, found);
    return TF_OK;
}

//: Take a batch of pairs at rest
enum {
    SOME_PAIRS = 16,
    PAIR_WORK = 16 ///< units of work that a pair takes
};

/// Takes the pairs of a join: a tf_pair_sink's function.
static bool take(tf_pair_sink *sink, int count, const tf_candidate pair[])
{
    tf_worker *worker = (tf_worker *)sink;
    const check_job *job = worker->job;
    tf_watch *watch = job->surface->workers.watch;
    if (!tf_worker_goes_on(worker, watch, 0))
        return false;
    for (int i = 0; i < count; i++) {
        if (i % SOME_PAIRS == 0 &&
            !tf_worker_works(worker, watch, (size_t)SOME_PAIRS * PAIR_WORK))
            return false;
        tf_crossing own = crossing_of(worker->job, pair[i]);
        bool found = false;
        worker->status = intersects(worker->job, own.vertex, &found);
        if (worker->status != TF_OK)
            return false;
        tf_crossing *row = found ? tf_worker_add(worker, sizeof *row) : &own;
        if (!row)
            return false;
        *row = own;
    }
    return true;
}

//: Compare crossings
static bool crosses_first(const void *first, const void *second)
{
    const tf_crossing *a = first, *b = second;
    if (a->kind != b->kind)
        return a->kind < b->kind;
    for (int i = 0; i < 5; i++)
        if (a->vertex[i] != b->vertex[i])
            return a->vertex[i] < b->vertex[i];
    return false;
}

//: Gather the crossings of all workers
static tf_status gather(tf_surface *surface, tf_crossings *found)
{
    tf_workers *workers = &surface->workers;
    size_t rows = tf_workers_rows(workers);
    tf_watch_stage(workers->watch, "crossings", rows);
    tf_status status =
        tf_workers_gather(workers, sizeof(tf_crossing), crosses_first,
                          &surface->sorting, &surface->found);
    if (status == TF_OK)
        *found = (tf_crossings){rows, surface->found.data};
    return status;
}

//: Join for one kind of crossing
static void join(tf_surface *surface, check_job *job, tf_crossing_kind kind,
                 const tf_parallel *parallel)
{
    shape s = shape_of(kind);
    job->kind = kind;
    if (tf_workers_status(&surface->workers) == TF_OK)
        tf_surface_join(surface, s.first, s.second, take, NULL, parallel);
}

//: Check a surface
static tf_status check(tf_surface *surface, check_job *job,
                       const tf_parallel *parallel, tf_crossings *found,
                       tf_error *error)
{
    tf_status status = tf_parallel_check(parallel, error);
    if (status == TF_OK)
        status = tf_surface_move(surface, &job->rest, true, parallel, error);
    if (status != TF_OK)
        return status;
    if (!tf_workers_begin(&surface->workers, tf_parallel_workers(parallel),
                          job))
        return tf_fail(error, TF_OUT_OF_MEMORY);
    if (surface->axes == 3) {
        join(surface, job, TF_EDGE_THROUGH_TRIANGLE, parallel);
        join(surface, job, TF_POINT_ON_TRIANGLE, parallel);
    }
    join(surface, job, TF_EDGE_ON_EDGE, parallel);
    status = tf_workers_status(&surface->workers);
    return tf_fail(error, status == TF_OK ? gather(surface, found) : status);
}

//: Check with the usual choices
tf_status tf_surface_check(tf_surface *surface, int vertices,
                           const double position[],
                           const tf_check_options *options, tf_crossings *found,
                           tf_error *error)
{
    TF_REQUIRE(surface && position && found);
    tf_check_options own;
    size_t first = offsetof(tf_check_options, context) + sizeof own.context;
    tf_status status = tf_options_read(&own, sizeof own, options, first, error);
    if (status != TF_OK)
        return status;
    check_job job = {.surface = surface,
                     .rest = {surface->axes, vertices, position, position}};
    tf_watch watch, *outer = tf_workers_watch(&surface->workers, &watch,
                                              own.progress, own.context);
    status = check(surface, &job, own.parallel, found, error);
    surface->workers.watch = outer;
    return status;
}
