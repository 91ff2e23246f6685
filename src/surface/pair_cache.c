//: Include what the cache of pairs needs
#include "surface/pair_cache.h"

#include "arithmetic/exact.h"
#include "base/fail.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

//: Keep the pairs of each worker
/// Pairs of one kind.
typedef struct pair_list {
    size_t count;
    tf_buffer pair;  ///< each a tf_candidate
    tf_buffer limit; ///< of each pair: how far it may move until it must be
                     ///< checked again; less than 0: it must be, moved or not
} pair_list;

/// The pairs with a vertex, and those of two edges, that one worker has kept.
typedef struct kept_pairs {
    pair_list points, edges;
} kept_pairs;

static pair_list *list_of(const tf_pair_cache *cache, int worker, tf_kind kind)
{
    kept_pairs *kept = (kept_pairs *)cache->kept.data + worker;
    return kind == TF_EDGE_EDGE ? &kept->edges : &kept->points;
}

/// Empties the lists of all workers, also of those that are new.  False if there
/// is no memory.
static bool empty_lists(tf_pair_cache *cache, int workers)
{
    if (!tf_buffer_extend(&cache->kept, (size_t)workers, sizeof(kept_pairs)))
        return false;
    kept_pairs *kept = cache->kept.data;
    for (; cache->workers < workers; cache->workers++)
        kept[cache->workers] = (kept_pairs){0};
    for (int i = 0; i < cache->workers; i++)
        kept[i].points.count = kept[i].edges.count = 0;
    return true;
}

//: Put a batch of pairs into the cache
/// Of pairs that are apart it is not known yet how far they may move.
static bool keep_batch(void *keeper, const tf_worker *worker, int count,
                       const tf_candidate pair[])
{
    const tf_pair_job *job = worker->job;
    pair_list *list = list_of(keeper, worker->number, job->kind);
    size_t kept = list->count, all = kept + (size_t)count;
    if (!tf_buffer_extend(&list->pair, all, sizeof *pair) ||
        !tf_buffer_extend(&list->limit, all, sizeof(double)))
        return false;
    memcpy((tf_candidate *)list->pair.data + kept, pair,
           sizeof *pair * (size_t)count);
    memcpy((double *)list->limit.data + kept, worker->clearance,
           sizeof(double) * (size_t)count);
    list->count = all;
    return true;
}

//: Remember the last checked ends
static size_t bytes_of_ends(const tf_contact_search *search)
{
    return sizeof(double) * (size_t)search->surface->axes *
           (size_t)search->surface->vertices;
}

static void note_ends(tf_pair_cache *cache, const tf_contact_search *search)
{
    memcpy(cache->checked.data, search->motion->end, bytes_of_ends(search));
}

bool tf_pair_cache_is_current(const tf_pair_cache *cache,
                              const tf_contact_search *search)
{
    return memcmp(cache->checked.data, search->motion->end,
                  bytes_of_ends(search)) == 0;
}

//: Hold how far everything has moved
/// How far each vertex has moved since the last check, and how far each vertex,
/// edge and triangle has since the cache was built: the sum, over all checks, of
/// the most that one of its vertices moved, where a movement by (dx, dy, dz)
/// counts as |dx| + |dy| + |dz|.
typedef struct movements {
    double *last, *vertex, *edge, *triangle;
} movements;

static movements movements_of(const tf_pair_cache *cache,
                              const tf_surface *surface)
{
    double *last = cache->movements.data, *vertex = last + surface->vertices;
    double *edge = vertex + surface->vertices;
    return (movements){last, vertex, edge, edge + surface->edges.count};
}

/// Nothing has moved.  False if there is no memory.
static bool begin_movements(tf_pair_cache *cache, const tf_surface *surface)
{
    size_t count = 2 * (size_t)surface->vertices +
                   (size_t)surface->edges.count +
                   (size_t)surface->triangles.count;
    if (!tf_buffer_reserve(&cache->movements, count, sizeof(double)))
        return false;
    memset(cache->movements.data, 0, sizeof(double) * count);
    return true;
}

//: Build the cache
static tf_pair_job job_of(const tf_contact_search *search)
{
    return (tf_pair_job){.surface = search->surface,
                         .motion = search->motion,
                         .arithmetic = &tf_exact,
                         .narrow_phase = search->narrow_phase,
                         .estimate = search->estimate};
}

tf_status tf_pair_cache_build(tf_pair_cache *cache,
                              const tf_contact_search *search,
                              tf_contacts *found, tf_error *error)
{
    tf_surface *surface = search->surface;
    tf_status status =
        tf_surface_move(surface, search->motion, true, search->parallel, error);
    if (status != TF_OK)
        return status;
    if (!empty_lists(cache, tf_parallel_workers(search->parallel)) ||
        !begin_movements(cache, surface) ||
        !tf_buffer_reserve(&cache->checked, bytes_of_ends(search), 1))
        return tf_fail(error, TF_OUT_OF_MEMORY);
    note_ends(cache, search);
    tf_pair_job job = job_of(search);
    job.keep = keep_batch;
    job.keeper = cache;
    return tf_fail(error,
                   tf_pairs_find(surface, &job, search->parallel, found));
}

//: Add up movements
static void move_vertices(int axes, int vertices, const double from[],
                          const double to[], const movements *moved)
{
    for (int v = 0; v < vertices; v++) {
        double sum = 0;
        for (int k = 0; k < axes; k++)
            sum += fabs(*to++ - *from++);
        moved->last[v] = sum;
        moved->vertex[v] += sum;
    }
}

static void move_elements(const tf_elements *elements, int corners,
                          const double last[], double moved[])
{
    const int *corner = elements->corner;
    for (int i = 0; i < elements->count; i++, corner += corners) {
        double most = last[corner[0]];
        for (int c = 1; c < corners; c++)
            most = last[corner[c]] > most ? last[corner[c]] : most;
        moved[i] += most;
    }
}

/// Adds the movements since the last check.
static movements add_movements(tf_pair_cache *cache,
                               const tf_contact_search *search)
{
    const tf_surface *surface = search->surface;
    movements moved = movements_of(cache, surface);
    move_vertices(surface->axes, surface->vertices, cache->checked.data,
                  search->motion->end, &moved);
    move_elements(&surface->edges, 2, moved.last, moved.edge);
    move_elements(&surface->triangles, 3, moved.last, moved.triangle);
    note_ends(cache, search);
    return moved;
}

//: Hold an update of the cache
/// The update of all pairs of one kind.
typedef struct update_job {
    tf_pair_cache *cache;
    const tf_workers *workers;
    tf_kind kind;
    const double *first, *second; ///< how far elements have moved
} update_job;

/// Each batch of a list is a task.
static int tasks_of(const pair_list *list)
{
    return (int)((list->count + TF_BATCH - 1) / TF_BATCH);
}

/// Finds the list that a task is of; sets the task's number in it.
static pair_list *list_of_task(const update_job *job, int *task)
{
    for (int worker = 0;; worker++) {
        pair_list *list = list_of(job->cache, worker, job->kind);
        if (*task < tasks_of(list))
            return list;
        *task -= tasks_of(list);
    }
}

//: Select the pairs that have moved too far
/// How far the elements of a pair have moved, in all.
static double movement_of(const update_job *job, tf_candidate pair)
{
    return job->first[pair.first] + job->second[pair.second];
}

/// Some pairs of a list.
typedef struct selection {
    int count;
    const tf_candidate *pair;
    double *limit;       ///< how far each may move
    int place[TF_BATCH]; ///< of those that have moved farther
} selection;

/// Writes the pairs that have moved too far to `to`; returns how many.
static int select_moved(const update_job *job, selection *some,
                        tf_candidate to[])
{
    int moved = 0;
    for (int i = 0; i < some->count; i++) {
        to[moved] = some->pair[i];
        some->place[moved] = i;
        moved += movement_of(job, some->pair[i]) > some->limit[i];
    }
    return moved;
}

//: Limit how far a pair may move
/// How far a pair that has moved so far may move until it must be checked
/// again.  What is taken off is more than the roundings of all sums, for
/// thousands of checks.  Where that is more than the clearance, the limit is
/// what it has moved by now.
static double limit_of(double moved, double clearance)
{
    double limit = (moved + clearance) * (1 - 0x1p-40);
    if (clearance < 0 || !isfinite(limit))
        return -1;
    return limit > moved ? limit : moved;
}

static void set_limits(const update_job *job, const selection *some, int count,
                       const tf_candidate pair[], const double clearance[])
{
    for (int i = 0; i < count; i++)
        some->limit[some->place[i]] =
            limit_of(movement_of(job, pair[i]), clearance[i]);
}

//: Check a batch of pairs again
static void update_batch(void *argument, int task, int number)
{
    const update_job *job = argument;
    const pair_list *list = list_of_task(job, &task);
    size_t begin = (size_t)task * TF_BATCH, rest = list->count - begin;
    selection some = {.count = rest < TF_BATCH ? (int)rest : TF_BATCH,
                      .pair = (const tf_candidate *)list->pair.data + begin,
                      .limit = (double *)list->limit.data + begin};
    tf_worker *worker = job->workers->worker[number];
    if (!tf_worker_goes_on(worker, job->workers->watch, 1))
        return;
    tf_pair_sink *sink = &worker->sink;
    sink->take = tf_pairs_take;
    int count = select_moved(job, &some, sink->pair);
    sink->count = count;
    tf_pair_sink_hand_on(sink);
    set_limits(job, &some, count, sink->pair, worker->clearance);
}

//: Check the pairs of a kind again
static tf_status update_kind(update_job *job, const tf_parallel *parallel)
{
    int tasks = 0;
    for (int i = 0; i < job->cache->workers; i++)
        tasks += tasks_of(list_of(job->cache, i, job->kind));
    tf_watch_stage(job->workers->watch, "pairs", (size_t)tasks);
    tf_parallel_for_each(parallel, tasks, update_batch, job);
    return tf_workers_status(job->workers);
}

static tf_status update_kinds(tf_pair_cache *cache, tf_surface *surface,
                              const movements *moved, tf_pair_job *pairs,
                              const tf_parallel *parallel)
{
    bool plane = surface->axes == 2;
    pairs->kind = plane ? TF_POINT_EDGE : TF_POINT_TRIANGLE;
    update_job job = {.cache = cache,
                      .workers = &surface->workers,
                      .kind = pairs->kind,
                      .first = moved->vertex,
                      .second = plane ? moved->edge : moved->triangle};
    tf_status status = update_kind(&job, parallel);
    if (status != TF_OK)
        return status;
    pairs->kind = job.kind = TF_EDGE_EDGE;
    job.first = job.second = moved->edge;
    return update_kind(&job, parallel);
}

//: Update the cache
tf_status tf_pair_cache_update(tf_pair_cache *cache,
                               const tf_contact_search *search,
                               tf_contacts *found)
{
    tf_surface *surface = search->surface;
    tf_pair_job job = job_of(search);
    job.measures = true;
    if (!tf_pairs_begin(surface, search->parallel, &job))
        return TF_OUT_OF_MEMORY;
    movements moved = add_movements(cache, search);
    tf_status status =
        update_kinds(cache, surface, &moved, &job, search->parallel);
    *found = (tf_contacts){0};
    if (status == TF_OK && !tf_pairs_gather(surface, job.selection, found))
        status = tf_watch_failure(surface->workers.watch);
    return status;
}

//: Account for the cache
static size_t list_bytes(const pair_list *list)
{
    return list->pair.bytes + list->limit.bytes;
}

static void free_list(pair_list *list)
{
    tf_buffer_free(&list->pair);
    tf_buffer_free(&list->limit);
}

size_t tf_pair_cache_memory(const tf_pair_cache *cache)
{
    const kept_pairs *kept = cache->kept.data;
    size_t bytes =
        cache->kept.bytes + cache->movements.bytes + cache->checked.bytes;
    for (int i = 0; i < cache->workers; i++)
        bytes += list_bytes(&kept[i].points) + list_bytes(&kept[i].edges);
    return bytes;
}

void tf_pair_cache_free(tf_pair_cache *cache)
{
    kept_pairs *kept = cache->kept.data;
    for (int i = 0; i < cache->workers; i++) {
        free_list(&kept[i].points);
        free_list(&kept[i].edges);
    }
    tf_buffer_free(&cache->kept);
    tf_buffer_free(&cache->movements);
    tf_buffer_free(&cache->checked);
    cache->workers = 0;
}
