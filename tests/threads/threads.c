// Tasks on several threads: each once, by one worker at a time.
#define _GNU_SOURCE // rlimit

#include "program/threads.h"

#include "support/support.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <time.h>

enum {
    TASKS = 10000
};

typedef struct work {
    int threads;
    atomic_int done[TASKS];
    atomic_int busy[TF_MOST_THREADS]; ///< tasks that a worker runs
    atomic_int wrong;
    int plain[TASKS]; ///< what tasks write is visible in the end
} work;

static void take(void *argument, int task, int worker)
{
    work *all = argument;
    if (worker < 0 || worker >= all->threads ||
        atomic_fetch_add(&all->busy[worker], 1) != 0) {
        atomic_fetch_add(&all->wrong, 1);
        return;
    }
    atomic_fetch_add(&all->done[task], 1);
    all->plain[task] = task + 1;
    atomic_fetch_sub(&all->busy[worker], 1);
}

static void expect_all_done(int threads, int tasks)
{
    work *all = calloc(1, sizeof *all);
    all->threads = threads;
    tf_parallel parallel = tf_threads(&threads);
    ck_assert_int_eq(parallel.workers, threads);
    parallel.for_each(parallel.context, tasks, take, all);
    ck_assert_int_eq(all->wrong, 0);
    for (int i = 0; i < TASKS; i++) {
        ck_assert_msg(all->done[i] == (i < tasks), "task %d of %d: %d times", i,
                      tasks, all->done[i]);
        ck_assert_int_eq(all->plain[i], i < tasks ? i + 1 : 0);
    }
    free(all);
}

START_TEST(each_task_is_run_once)
{
    static const int threads[] = {1, 2, 3, 8, TF_MOST_THREADS};
    static const int tasks[] = {0, 1, 2, 7, 1000, TASKS};
    for (int i = 0; i < 5; i++)
        for (int j = 0; j < 6; j++)
            expect_all_done(threads[i], tasks[j]);
}
END_TEST

/// Waits until two tasks run at once, ten seconds at most.
static void wait_for_other(void *argument, int task, int worker)
{
    atomic_int *waiting = argument;
    (void)task;
    (void)worker;
    atomic_fetch_add(waiting, 1);
    for (int i = 0; i < 10000 && atomic_load(waiting) < 2; i++)
        nanosleep(&(struct timespec){0, 1000000}, NULL);
}

START_TEST(tasks_run_at_once)
{
    int threads = 2;
    atomic_int waiting = 0;
    tf_parallel parallel = tf_threads(&threads);
    time_t begin = time(NULL);
    parallel.for_each(parallel.context, 2, wait_for_other, &waiting);
    ck_assert_int_eq(waiting, 2);
    ck_assert_msg(time(NULL) - begin < 9, "one after the other");
}
END_TEST

START_TEST(tasks_are_done_without_more_threads)
{
#ifndef __SANITIZE_ADDRESS__ // which needs memory of its own
    // No memory for another stack: the caller's thread does all the work.
    struct rlimit none = {1 << 20, 1 << 20};
    struct rlimit before;
    ck_assert_int_eq(getrlimit(RLIMIT_AS, &before), 0);
    none.rlim_max = before.rlim_max;
    work *all = calloc(1, sizeof *all);
    all->threads = 8;
    tf_parallel parallel = tf_threads(&all->threads);
    ck_assert_int_eq(setrlimit(RLIMIT_AS, &none), 0);
    parallel.for_each(parallel.context, TASKS, take, all);
    ck_assert_int_eq(setrlimit(RLIMIT_AS, &before), 0);
    ck_assert_int_eq(all->wrong, 0);
    for (int i = 0; i < TASKS; i++)
        ck_assert_int_eq(all->done[i], 1);
    free(all);
#endif
}
END_TEST

START_TEST(threads_are_available)
{
    int available = tf_threads_available();
    ck_assert_int_ge(available, 1);
    ck_assert_int_le(available, TF_MOST_THREADS);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/threads");
    TCase *threads = tcase_create("threads");
    tcase_add_test(threads, each_task_is_run_once);
    tcase_add_test(threads, tasks_run_at_once);
    tcase_add_test(threads, tasks_are_done_without_more_threads);
    tcase_add_test(threads, threads_are_available);
    suite_add_tcase(suite, threads);
    return suite;
}
