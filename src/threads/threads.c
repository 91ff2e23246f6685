//: Include what a pool of threads needs
#define _GNU_SOURCE // sched_getaffinity
#include "threads/threads.h"

#include <fenv.h>
#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdlib.h>
#include <unistd.h>

//: Hold the tasks of a call
/// What a call of for_each has the threads do.
typedef struct job {
    int count; ///< of tasks
    tf_task *run;
    void *argument;
    fenv_t environment; ///< of the caller
    atomic_uint next;   ///< the next task; in the end more than there are
} job;

//: Hold a pool of threads
typedef struct member {
    tf_threads *pool;
    int worker;
    pthread_t thread;
} member;

struct tf_threads {
    tf_parallel parallel;
    unsigned forks;       ///< those before the pool was made
    pthread_mutex_t turn; ///< held during a call of for_each
    pthread_mutex_t lock; ///< held to use all below
    pthread_cond_t wake, rest;
    job job;
    bool open;   ///< the job may have tasks that nobody has taken
    int running; ///< threads that are taking its tasks
    bool ended;
    member member[TF_MOST_THREADS]; ///< the caller, worker 0, is none
};

//: Take one task after another
static _Thread_local bool in_task;

static void take_tasks(job *own, int worker)
{
    in_task = true;
    for (;;) {
        unsigned task = atomic_fetch_add(&own->next, 1);
        if (task >= (unsigned)own->count)
            break;
        own->run(own->argument, (int)task, worker);
    }
    in_task = false;
}

//: Take part in a job
/// The lock is held before and after, but not while tasks run.
static void take_part(tf_threads *pool, int worker)
{
    pool->running++;
    // Each thread wakes two, so that soon all are awake.
    pthread_cond_signal(&pool->wake);
    pthread_cond_signal(&pool->wake);
    pthread_mutex_unlock(&pool->lock);
    fesetenv(&pool->job.environment);
    take_tasks(&pool->job, worker);
    pthread_mutex_lock(&pool->lock);
    pool->open = false;
    if (--pool->running == 0)
        pthread_cond_signal(&pool->rest);
}

//: Serve in a pool
static void *serve(void *argument)
{
    const member *own = argument;
    tf_threads *pool = own->pool;
    pthread_mutex_lock(&pool->lock);
    while (!pool->ended)
        if (pool->open)
            take_part(pool, own->worker);
        else
            pthread_cond_wait(&pool->wake, &pool->lock);
    pthread_mutex_unlock(&pool->lock);
    return NULL;
}

//: Count forks
/// A fork copies the thread that calls it and no other: it makes a process that
/// has pools, but none of their threads.
static unsigned forks;
static int unable_to_count;

static void count_fork(void)
{
    forks++;
}

static void count_forks(void)
{
    unable_to_count = pthread_atfork(NULL, NULL, count_fork);
}

//: Run tasks on the threads of a pool
static void run_together(tf_threads *pool, int count, tf_task *run,
                         void *argument)
{
    pthread_mutex_lock(&pool->turn);
    pthread_mutex_lock(&pool->lock);
    pool->job = (job){.count = count, .run = run, .argument = argument};
    fegetenv(&pool->job.environment);
    pool->open = true;
    take_part(pool, 0);
    while (pool->running > 0)
        pthread_cond_wait(&pool->rest, &pool->lock);
    pthread_mutex_unlock(&pool->lock);
    pthread_mutex_unlock(&pool->turn);
}

//: Run tasks alone or on the threads of a pool
static void run_alone(int count, tf_task *run, void *argument)
{
    for (int task = 0; task < count; task++)
        run(argument, task, 0);
}

static void for_each(void *context, int count, tf_task *run, void *argument)
{
    tf_threads *pool = context;
    if (in_task || count < 2 || pool->forks != forks)
        run_alone(count, run, argument);
    else
        run_together(pool, count, run, argument);
}

//: Count the processors
static int count_processors(void)
{
    long count = sysconf(_SC_NPROCESSORS_ONLN);
#ifdef CPU_COUNT // Linux
    cpu_set_t allowed;
    if (sched_getaffinity(0, sizeof allowed, &allowed) == 0)
        count = CPU_COUNT(&allowed);
#endif
    return count < 1                 ? 1
           : count > TF_MOST_THREADS ? TF_MOST_THREADS
                                     : (int)count;
}

//: Start the threads of a pool
static void start(tf_threads *pool, int count)
{
    int *started = &pool->parallel.workers;
    for (*started = 1; *started < count; (*started)++) {
        member *own = &pool->member[*started];
        *own = (member){.pool = pool, .worker = *started};
        if (pthread_create(&own->thread, NULL, serve, own) != 0)
            return;
    }
}

//: Make a pool of threads
tf_status tf_threads_create(int count, tf_threads **threads)
{
    static pthread_once_t once = PTHREAD_ONCE_INIT;
    *threads = NULL;
    if (count < 0 || count > TF_MOST_THREADS)
        return TF_BAD_OPTION;
    pthread_once(&once, count_forks);
    tf_threads *pool = unable_to_count ? NULL : malloc(sizeof *pool);
    if (!pool)
        return TF_OUT_OF_MEMORY;
    *pool = (tf_threads){.parallel = {.for_each = for_each, .context = pool},
                         .forks = forks,
                         .turn = PTHREAD_MUTEX_INITIALIZER,
                         .lock = PTHREAD_MUTEX_INITIALIZER,
                         .wake = PTHREAD_COND_INITIALIZER,
                         .rest = PTHREAD_COND_INITIALIZER};
    start(pool, count > 0 ? count : count_processors());
    *threads = pool;
    return TF_OK;
}

//: End the threads of a pool
static void end(tf_threads *pool)
{
    pthread_mutex_lock(&pool->lock);
    pool->ended = true;
    pthread_cond_broadcast(&pool->wake);
    pthread_mutex_unlock(&pool->lock);
    for (int i = 1; i < pool->parallel.workers; i++)
        pthread_join(pool->member[i].thread, NULL);
    pthread_cond_destroy(&pool->rest);
    pthread_cond_destroy(&pool->wake);
    pthread_mutex_destroy(&pool->lock);
    pthread_mutex_destroy(&pool->turn);
}

void tf_threads_free(tf_threads *threads)
{
    if (threads && threads->forks == forks)
        end(threads);
    free(threads);
}

//: Tell of a pool of threads
const tf_parallel *tf_threads_parallel(const tf_threads *threads)
{
    return threads ? &threads->parallel : NULL;
}

int tf_threads_count(const tf_threads *threads)
{
    return threads ? threads->parallel.workers : 1;
}
