//: Include what the search of near pairs needs
#include "distance/near_search.h"

#include "base/environment.h"
#include "base/fail.h"
#include "distance/nearer.h"
#include "query/apart.h"
#include "surface/filtered_join.h"
#include "surface/pair_vertices.h"

#include <float.h>
#include <math.h>

//: Enlarge what the vertices sweep
/// x + by, or x itself unless it is finite, and never beyond the largest double.
static double shifted(double x, double by)
{
    return isfinite(x) ? fmax(-DBL_MAX, fmin(x + by, DBL_MAX)) : x;
}

/// A motion by which each vertex sweeps a cube around its position, with sides of
/// the length that is searched: boxes around what two elements sweep are then
/// apart only if the elements are not nearer to each other.  For rounding keeps
/// the order of numbers: from y - x < 2 r follows y - r < x + r, rounded or not.
static bool enlarge(const tf_near_search *search, tf_motion *motion)
{
    tf_surface *surface = search->surface;
    size_t numbers = (size_t)surface->axes * (size_t)surface->vertices;
    if (!tf_buffer_reserve(&surface->enlarged, 2 * numbers, sizeof(double)))
        return false;
    double *low = surface->enlarged.data, *high = low + numbers;
    // The least double has no half.
    double radius = fmax(search->length / 2, DBL_TRUE_MIN);
    for (size_t i = 0; i < numbers; i++) {
        low[i] = shifted(search->position[i], -radius);
        high[i] = shifted(search->position[i], radius);
    }
    *motion = (tf_motion){surface->axes, surface->vertices, low, high};
    return true;
}

//: Decide whether a pair is wanted
typedef struct near_job {
    const tf_near_search *search;
    tf_kind kind; ///< of the pairs that come next
} near_job;

static void name_pair(const near_job *job, tf_candidate candidate,
                      tf_near_pair *pair)
{
    const tf_surface *surface = job->search->surface;
    pair->kind = job->kind;
    pair->vertex[3] = -1;
    if (job->kind == TF_EDGE_EDGE)
        tf_pair_vertices(surface, 2, 2, candidate, pair->vertex);
    else if (job->kind == TF_POINT_TRIANGLE)
        tf_pair_vertices(surface, 1, 3, candidate, pair->vertex);
    else
        tf_pair_vertices(surface, 1, 2, candidate, pair->vertex);
}

/// Whether a pair is nearer than the length at some positions.
static bool is_near_at(const near_job *job, const tf_near_pair *pair,
                       const double position[])
{
    int axes = job->search->surface->axes;
    const double *x[4] = {NULL};
    for (int i = 0; i <= axes; i++)
        x[i] = position + (ptrdiff_t)axes * pair->vertex[i];
    return tf_are_nearer(job->kind, x, job->search->length);
}

static bool is_pair_wanted(const near_job *job, const tf_near_pair *pair)
{
    const tf_near_search *search = job->search;
    return is_near_at(job, pair, search->position) &&
           !(search->before && is_near_at(job, pair, search->before));
}

//: Take a batch of pairs that may be near
enum {
    NEAR_WORK = 32 ///< units of work that a pair takes
};

/// Takes the pairs of a join: a tf_pair_sink's function.
static bool take_near(tf_pair_sink *sink, int count, const tf_candidate pair[])
{
    tf_worker *worker = (tf_worker *)sink;
    const near_job *job = worker->job;
    tf_watch *watch = job->search->surface->workers.watch;
    if (!tf_worker_goes_on(worker, watch, 0))
        return false;
    if (!tf_environment_is_ieee()) {
        worker->status = TF_BAD_ENVIRONMENT;
        return false;
    }
    for (int i = 0; i < count; i++) {
        tf_near_pair own;
        if (!tf_worker_works(worker, watch, NEAR_WORK))
            return false;
        name_pair(job, pair[i], &own);
        if (!is_pair_wanted(job, &own))
            continue;
        tf_near_pair *row = tf_worker_add(worker, sizeof *row);
        if (!row)
            return false;
        *row = own;
    }
    return true;
}

//: Gather the near pairs of all workers
static bool is_listed_first(const void *first, const void *second)
{
    const tf_near_pair *a = first, *b = second;
    if (a->kind != b->kind)
        return a->kind < b->kind;
    for (int i = 0; i < 4; i++)
        if (a->vertex[i] != b->vertex[i])
            return a->vertex[i] < b->vertex[i];
    return false;
}

static tf_status gather_near(tf_surface *surface, tf_near_pairs *found)
{
    tf_workers *workers = &surface->workers;
    tf_status status =
        tf_workers_gather(workers, sizeof(tf_near_pair), is_listed_first,
                          &surface->sorting, &surface->found);
    if (status == TF_OK)
        *found = (tf_near_pairs){tf_workers_rows(workers), surface->found.data};
    return status;
}

//: Search near pairs
static void join_near(tf_surface *surface, near_job *job,
                      const tf_parallel *parallel)
{
    bool plane = surface->axes == 2;
    job->kind = plane ? TF_POINT_EDGE : TF_POINT_TRIANGLE;
    tf_surface_join(surface, 1, surface->axes, take_near, NULL, parallel);
    job->kind = TF_EDGE_EDGE;
    if (!plane && tf_workers_status(&surface->workers) == TF_OK)
        tf_surface_join(surface, 2, 2, take_near, NULL, parallel);
}

tf_status tf_near_search_run(const tf_near_search *search, tf_near_pairs *found,
                             tf_error *error)
{
    tf_surface *surface = search->surface;
    const tf_parallel *parallel = search->parallel;
    tf_motion motion;
    near_job job = {.search = search};
    if (search->vertices != surface->vertices)
        return tf_fail(error, TF_BAD_COUNT);
    if (!enlarge(search, &motion))
        return tf_fail(error, TF_OUT_OF_MEMORY);
    tf_status status = tf_surface_move(surface, &motion, true, parallel, error);
    if (status != TF_OK)
        return status;
    if (!tf_workers_begin(&surface->workers, tf_parallel_workers(parallel),
                          &job))
        return tf_fail(error, TF_OUT_OF_MEMORY);
    join_near(surface, &job, parallel);
    status = tf_workers_status(&surface->workers);
    return tf_fail(error,
                   status == TF_OK ? gather_near(surface, found) : status);
}
