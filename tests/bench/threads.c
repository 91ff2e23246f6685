// What it costs to run tasks on several threads: calls of for_each with empty
// tasks, by a pool and by threads that are started for each call.  Prints lines
// "name,value,unit" for figures/measured/threads.csv: microseconds a call by the
// clock, the median of several runs.
#define _POSIX_C_SOURCE 200809L // clock_gettime

#include "threads/threads.h"

#include "bench/measuring.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum {
    TASKS = 16,
    CALLS = 100,
    RUNS = 101
};

static void do_nothing(void *argument, int task, int worker)
{
    (void)argument;
    (void)task;
    (void)worker;
}

// Threads for a call ------------------------------------------------------------

typedef struct crew {
    int count;
    tf_task *run;
    void *argument;
    atomic_int next, workers;
} crew;

static void *take_tasks(void *argument)
{
    crew *all = argument;
    int worker = atomic_fetch_add(&all->workers, 1), task;
    while ((task = atomic_fetch_add(&all->next, 1)) < all->count)
        all->run(all->argument, task, worker);
    return NULL;
}

static void start_threads(void *context, int count, tf_task *run,
                          void *argument)
{
    int threads = *(const int *)context, started = 0;
    crew all = {.count = count, .run = run, .argument = argument};
    pthread_t thread[TF_MOST_THREADS];
    while (started < threads - 1 &&
           pthread_create(&thread[started], NULL, take_tasks, &all) == 0)
        started++;
    take_tasks(&all);
    for (int i = 0; i < started; i++)
        pthread_join(thread[i], NULL);
}

// Measuring ---------------------------------------------------------------------

static double microseconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return 1e6 * (double)now.tv_sec + 1e-3 * (double)now.tv_nsec;
}

static int compare(const void *a, const void *b)
{
    double first = *(const double *)a, second = *(const double *)b;
    return (first > second) - (first < second);
}

static void measure(const char *name, int threads, const tf_parallel *parallel)
{
    double time[RUNS];
    for (int i = 0; i < RUNS; i++) {
        double begin = microseconds();
        for (int j = 0; j < CALLS; j++)
            parallel->for_each(parallel->context, TASKS, do_nothing, NULL);
        time[i] = (microseconds() - begin) / CALLS;
    }
    qsort(time, RUNS, sizeof *time, compare);
    printf("%s %d,%.3f,us\n", name, threads, time[RUNS / 2]);
}

int main(void)
{
    static const int counts[] = {2, 4, 8, 16};
    tf_threads *threads;
    require(tf_threads_create(0, &threads));
    printf("processors,%d,\n", tf_threads_count(threads));
    tf_threads_free(threads);
    for (int i = 0; i < 4; i++) {
        int count = counts[i];
        require(tf_threads_create(count, &threads));
        measure("pool of", count, tf_threads_parallel(threads));
        tf_threads_free(threads);
        measure("start of", count,
                &(tf_parallel){count, start_threads, &count});
    }
    return 0;
}
