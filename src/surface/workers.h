//: Declare the workers
#pragma once

#include "base/status.h"
#include "base/watch.h"
#include "surface/join.h"
#include "surface/sort.h"

/// What one of several threads finds, in memory that is kept.
typedef struct tf_worker {
    tf_pair_sink sink;          ///< first, so that a sink is its worker
    int number;                 ///< of the worker, from 0
    const void *job;            ///< what all workers share
    tf_status status;           ///< other than TF_OK: it could not go on
    size_t rows;                ///< how many it has found
    tf_buffer row;              ///< these rows
    tf_buffer batch;            ///< workspace for a batch of pairs
    double clearance[TF_BATCH]; ///< of the pairs of the last batch, if the job
                                ///< asks for it: how far their ends may move
                                ///< before they could meet, at least; -1: they
                                ///< are in contact
} tf_worker;

/// The workers of a surface.
typedef struct tf_workers {
    int count;
    tf_worker **worker; ///< each has memory of its own
    tf_buffer storage;  ///< of these pointers
    tf_watch *watch;    ///< over the call that they work for; or NULL
} tf_workers;

/// Readies workers for a job.  False if there is no memory.
bool tf_workers_begin(tf_workers *workers, int count, const void *job);

/// Adds a row of some size to what a worker has found, all zero (also what is
/// between its members, so that rows can be compared by their bytes); NULL, with
/// a status, if there is no memory.
void *tf_worker_add(tf_worker *worker, size_t size);

/// Adds pairs to what a worker has found; false, with a status, if there is no
/// memory.
bool tf_worker_add_pairs(tf_worker *worker, int count,
                         const tf_candidate pair[]);

/// Has a call be watched from now on, if there is a callback; returns the watch
/// so far, which is to be put back when the call ends.
tf_watch *tf_workers_watch(tf_workers *workers, tf_watch *watch,
                           tf_progress *progress, void *context);

/// Tells the watch that more of its stage is done; false, with a status, if the
/// call is cancelled.
bool tf_worker_goes_on(tf_worker *worker, tf_watch *watch, size_t more);

/// The same for units of work in a loop; see tf_watch_work.
bool tf_worker_works(tf_worker *worker, tf_watch *watch, size_t units);

/// The first status that is not TF_OK, or TF_OK.
tf_status tf_workers_status(const tf_workers *workers);

/// How many rows all workers have found.
size_t tf_workers_rows(const tf_workers *workers);

/// Sorts what all workers have found, rows of `size` bytes, into `found`, by way
/// of `sorting`.  Returns TF_OK, TF_OUT_OF_MEMORY or TF_CANCELLED.
tf_status tf_workers_gather(const tf_workers *workers, size_t size,
                            tf_precedes *precedes, tf_buffer *sorting,
                            tf_buffer *found);

size_t tf_workers_memory(const tf_workers *workers);
void tf_workers_free(tf_workers *workers);

//: Declare how workers join two trees
/// The rows that a task has found.
typedef struct tf_task_rows {
    int worker;
    size_t begin, end;
} tf_task_rows;

/// How many tasks the join of a tree with another has.
int tf_join_tasks(const tf_tree *s);

/// Joins two trees; each worker takes pairs by `take`, which returns false when
/// nothing more is wanted of any worker.  Notes the rows of each task, unless
/// `rows` is NULL.
void tf_workers_join(tf_workers *workers, const tf_tree *s, const tf_tree *t,
                     bool (*take)(tf_pair_sink *, int, const tf_candidate[]),
                     tf_task_rows rows[], const tf_parallel *parallel);
