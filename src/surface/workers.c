//: Include what workers need
#include "surface/workers.h"

#include "base/memory.h"

#include <stdatomic.h>
#include <string.h>

//: Hire workers
static bool hire(tf_workers *workers, int count)
{
    if (!tf_buffer_extend(&workers->storage, (size_t)count,
                          sizeof *workers->worker))
        return false;
    workers->worker = workers->storage.data;
    for (; workers->count < count; workers->count++) {
        tf_worker *worker = tf_allocate_zeroed(sizeof *worker);
        if (!worker)
            return false;
        worker->number = workers->count;
        workers->worker[workers->count] = worker;
    }
    return true;
}

//: Ready workers for a job
bool tf_workers_begin(tf_workers *workers, int count, const void *job)
{
    if (!hire(workers, count))
        return false;
    for (int i = 0; i < workers->count; i++) {
        tf_worker *worker = workers->worker[i];
        worker->job = job;
        worker->status = TF_OK;
        worker->rows = 0;
        worker->sink.count = 0;
        worker->sink.stopped = false;
    }
    return true;
}

//: Watch workers
tf_watch *tf_workers_watch(tf_workers *workers, tf_watch *watch,
                           tf_progress *progress, void *context)
{
    tf_watch *outer = workers->watch;
    if (progress)
        workers->watch = tf_watch_begin(watch, progress, context);
    return outer;
}

bool tf_worker_goes_on(tf_worker *worker, tf_watch *watch, size_t more)
{
    if (!tf_watch_done(watch, more))
        worker->status = TF_CANCELLED;
    return worker->status == TF_OK;
}

bool tf_worker_works(tf_worker *worker, tf_watch *watch, size_t units)
{
    if (!tf_watch_work(watch, units))
        worker->status = TF_CANCELLED;
    return worker->status == TF_OK;
}

//: Keep what workers find
void *tf_worker_add(tf_worker *worker, size_t size)
{
    if (!tf_buffer_extend(&worker->row, worker->rows + 1, size)) {
        worker->status = TF_OUT_OF_MEMORY;
        return NULL;
    }
    char *row = (char *)worker->row.data + size * worker->rows++;
    return memset(row, 0, size);
}

bool tf_worker_add_pairs(tf_worker *worker, int count,
                         const tf_candidate pair[])
{
    size_t rows = worker->rows + (size_t)count;
    if (!tf_buffer_extend(&worker->row, rows, sizeof *pair)) {
        worker->status = TF_OUT_OF_MEMORY;
        return false;
    }
    memcpy((tf_candidate *)worker->row.data + worker->rows, pair,
           sizeof *pair * (size_t)count);
    worker->rows = rows;
    return true;
}

tf_status tf_workers_status(const tf_workers *workers)
{
    for (int i = 0; i < workers->count; i++)
        if (workers->worker[i]->status != TF_OK)
            return workers->worker[i]->status;
    return TF_OK;
}

size_t tf_workers_rows(const tf_workers *workers)
{
    size_t rows = 0;
    for (int i = 0; i < workers->count; i++)
        rows += workers->worker[i]->rows;
    return rows;
}

//: Gather what workers find
static void list_all_rows(const tf_workers *workers, size_t size,
                          const void *list[])
{
    for (int i = 0; i < workers->count; i++) {
        const tf_worker *worker = workers->worker[i];
        const char *row = worker->row.data;
        for (size_t j = 0; j < worker->rows; j++)
            *list++ = row + size * j;
    }
}

tf_status tf_workers_gather(const tf_workers *workers, size_t size,
                            tf_precedes *precedes, tf_buffer *sorting,
                            tf_buffer *found)
{
    size_t rows = tf_workers_rows(workers);
    tf_watch *watch = workers->watch;
    if (!tf_buffer_reserve(found, rows + 1, size) ||
        !tf_buffer_reserve(sorting, 2 * rows + 1, sizeof(void *)))
        return TF_OUT_OF_MEMORY;
    const void **list = sorting->data;
    list_all_rows(workers, size, list);
    list = tf_sort(rows, list, list + rows, precedes, watch);
    char *to = found->data;
    for (size_t i = 0; list && i < rows && tf_watch_work(watch, 1); i++)
        memcpy(to + size * i, list[i], size);
    return tf_watch_cancelled(watch) ? TF_CANCELLED : TF_OK;
}

//: Account for workers
size_t tf_workers_memory(const tf_workers *workers)
{
    size_t bytes = workers->storage.bytes;
    for (int i = 0; i < workers->count; i++) {
        const tf_worker *worker = workers->worker[i];
        bytes += sizeof *worker + worker->row.bytes + worker->batch.bytes;
    }
    return bytes;
}

void tf_workers_free(tf_workers *workers)
{
    for (int i = 0; i < workers->count; i++) {
        tf_worker *worker = workers->worker[i];
        tf_buffer_free(&worker->row);
        tf_buffer_free(&worker->batch);
        tf_release(worker, sizeof *worker);
    }
    tf_buffer_free(&workers->storage);
    *workers = (tf_workers){0};
}

//: Join a part of a tree
typedef struct join_job {
    tf_workers *workers;
    const tf_tree *s, *t;
    tf_task_rows *rows;
    atomic_bool stopped;
} join_job;

static void join_part(void *argument, int task, int number)
{
    join_job *job = argument;
    tf_worker *worker = job->workers->worker[number];
    size_t begin = worker->rows;
    if (!tf_worker_goes_on(worker, job->workers->watch, 1))
        atomic_store(&job->stopped, true);
    if (!atomic_load(&job->stopped)) {
        tf_tree_join(job->s, job->t,
                     tf_range_part(job->s->packs[0], TF_JOIN_PART, task),
                     &worker->sink);
        if (worker->sink.stopped)
            atomic_store(&job->stopped, true);
    }
    if (job->rows)
        job->rows[task] = (tf_task_rows){number, begin, worker->rows};
}

//: Join two trees in parallel
int tf_join_tasks(const tf_tree *s)
{
    return s->count == 0 ? 0 : tf_range_parts(s->packs[0], TF_JOIN_PART);
}

void tf_workers_join(tf_workers *workers, const tf_tree *s, const tf_tree *t,
                     bool (*take)(tf_pair_sink *, int, const tf_candidate[]),
                     tf_task_rows rows[], const tf_parallel *parallel)
{
    join_job job = {.workers = workers, .s = s, .t = t, .rows = rows};
    for (int i = 0; i < workers->count; i++)
        workers->worker[i]->sink.take = take;
    tf_watch_stage(workers->watch, "pairs", (size_t)tf_join_tasks(s));
    tf_parallel_for_each(parallel, tf_join_tasks(s), join_part, &job);
}
