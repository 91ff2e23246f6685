// Tasks on the threads of a pool: each once, by one worker at a time, whoever
// else uses the pool.
#define _GNU_SOURCE // sched_setaffinity

#include "threads/threads.h"

#include "base/environment.h"
#include "support/support.h"

#include <errno.h>
#include <fenv.h>
#include <limits.h>
#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum {
    TASKS = 1000
};

// What fails -------------------------------------------------------------------

static atomic_int threads_left = INT_MAX; ///< that can be started
static atomic_bool no_memory;

// The names are the linker's.
int __real_pthread_create(pthread_t *thread, const pthread_attr_t *attributes,
                          void *(*run)(void *), void *argument);
void *__real_malloc(size_t size);
int __wrap_pthread_create(pthread_t *thread, const pthread_attr_t *attributes,
                          void *(*run)(void *), void *argument);
void *__wrap_malloc(size_t size);

int __wrap_pthread_create(pthread_t *thread, const pthread_attr_t *attributes,
                          void *(*run)(void *), void *argument)
{
    return atomic_fetch_sub(&threads_left, 1) > 0
               ? __real_pthread_create(thread, attributes, run, argument)
               : EAGAIN;
}

void *__wrap_malloc(size_t size)
{
    return no_memory ? NULL : __real_malloc(size);
}

// Pools -------------------------------------------------------------------------

/// Ends the test after a minute, if threads wait for each other in vain.
static tf_threads *pool_of(int count)
{
    tf_threads *threads;
    alarm(60);
    ck_assert_int_eq(tf_threads_create(count, &threads), TF_OK);
    return threads;
}

static void run(const tf_threads *threads, int count, tf_task *task,
                void *argument)
{
    const tf_parallel *parallel = tf_threads_parallel(threads);
    parallel->for_each(parallel->context, count, task, argument);
}

/// What tasks count, and what those of other calls count with them.
typedef struct work {
    const tf_threads *threads;
    atomic_int *busy; ///< tasks that a worker runs
    atomic_int wrong;
    atomic_int done[TASKS];
    int plain[TASKS]; ///< what tasks write is visible in the end
} work;

static void take(void *argument, int task, int worker)
{
    work *all = argument;
    if (worker < 0 || worker >= tf_threads_count(all->threads) ||
        atomic_fetch_add(&all->busy[worker], 1) != 0)
        atomic_fetch_add(&all->wrong, 1);
    atomic_fetch_add(&all->done[task], 1);
    all->plain[task] = task + 1;
    atomic_fetch_sub(&all->busy[worker], 1);
}

/// False: a task was not run, or twice, or by a worker that runs another one.
static bool run_tasks(const tf_threads *threads, int count, atomic_int busy[])
{
    work *all = calloc(1, sizeof *all);
    all->threads = threads;
    all->busy = busy;
    run(threads, count, take, all);
    bool good = all->wrong == 0;
    for (int i = 0; i < TASKS; i++)
        good = good && all->done[i] == (i < count) &&
               all->plain[i] == (i < count ? i + 1 : 0);
    free(all);
    return good;
}

static void expect_all_done(const tf_threads *threads)
{
    static const int tasks[] = {0, 1, 2, 7, 100, TASKS};
    atomic_int busy[TF_MOST_THREADS] = {0};
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 20; j++)
            ck_assert_msg(run_tasks(threads, tasks[i], busy),
                          "%d tasks by %d threads", tasks[i],
                          tf_threads_count(threads));
}

// Tasks ---------------------------------------------------------------------------

START_TEST(each_task_is_run_once)
{
    static const int counts[] = {1, 2, 3, 8, TF_MOST_THREADS};
    for (int i = 0; i < 5; i++) {
        tf_threads *threads = pool_of(counts[i]);
        ck_assert_int_eq(tf_threads_count(threads), counts[i]);
        ck_assert_int_eq(tf_threads_parallel(threads)->workers, counts[i]);
        expect_all_done(threads);
        tf_threads_free(threads);
    }
}
END_TEST

static void sleep_milliseconds(int count)
{
    nanosleep(&(struct timespec){0, 1000000L * count}, NULL);
}

/// Waits until as many tasks are here at once.
static void meet(atomic_int *here, int count)
{
    atomic_fetch_add(here, 1);
    while (atomic_load(here) < count)
        sleep_milliseconds(1);
}

static void meet_three(void *argument, int task, int worker)
{
    (void)task;
    (void)worker;
    meet(argument, 3);
}

START_TEST(tasks_run_at_once)
{
    tf_threads *threads = pool_of(3);
    for (int i = 0; i < 100; i++) {
        atomic_int here = 0;
        run(threads, 3, meet_three, &here);
    }
    tf_threads_free(threads);
}
END_TEST

START_TEST(threads_sleep_without_tasks)
{
    tf_threads *threads = pool_of(8);
    expect_all_done(threads);
    sleep_milliseconds(20);
    clock_t begin = clock();
    sleep_milliseconds(400);
    ck_assert_int_lt(clock() - begin, CLOCKS_PER_SEC / 10);
    tf_threads_free(threads);
}
END_TEST

/// One that waits for the other leaves the rest of the threads nothing to do.
static void sleep_first(void *argument, int task, int worker)
{
    (void)argument;
    (void)worker;
    if (task == 0)
        sleep_milliseconds(400);
}

START_TEST(threads_sleep_while_the_last_task_runs)
{
    tf_threads *threads = pool_of(8);
    clock_t begin = clock();
    run(threads, 8, sleep_first, NULL);
    ck_assert_int_lt(clock() - begin, CLOCKS_PER_SEC / 10);
    tf_threads_free(threads);
}
END_TEST

// Several calls ---------------------------------------------------------------------

enum {
    CALLERS = 4
};

typedef struct caller {
    const tf_threads *threads;
    atomic_int *busy;
    bool good;
    pthread_t thread;
} caller;

static void *call_often(void *argument)
{
    caller *own = argument;
    own->good = true;
    for (int i = 0; i < (int)cases(200); i++)
        own->good = run_tasks(own->threads, 2 + i % 7, own->busy) && own->good;
    return NULL;
}

START_TEST(calls_take_turns)
{
    caller callers[CALLERS];
    atomic_int busy[3] = {0};
    tf_threads *threads = pool_of(3);
    for (int i = 0; i < CALLERS; i++) {
        callers[i] = (caller){.threads = threads, .busy = busy};
        ck_assert_int_eq(
            pthread_create(&callers[i].thread, NULL, call_often, &callers[i]),
            0);
    }
    for (int i = 0; i < CALLERS; i++) {
        pthread_join(callers[i].thread, NULL);
        ck_assert(callers[i].good);
    }
    tf_threads_free(threads);
}
END_TEST

/// Two pools whose tasks run tasks on the other one.
typedef struct nest {
    tf_threads *threads[2];
    atomic_int here, inner;
} nest;

static void count_inner(void *argument, int task, int worker)
{
    nest *own = argument;
    (void)task;
    if (worker == 0)
        atomic_fetch_add(&own->inner, 1);
}

static void run_inner(void *argument, int task, int worker)
{
    nest *own = argument;
    (void)worker;
    meet(&own->here, 4);
    run(own->threads[task], 10, count_inner, own);
}

static void *run_other(void *argument)
{
    nest *own = argument;
    run(own->threads[1], 2, run_inner, own);
    return NULL;
}

START_TEST(tasks_may_run_tasks)
{
    nest own = {{pool_of(2), pool_of(2)}, 0, 0};
    pthread_t thread;
    ck_assert_int_eq(pthread_create(&thread, NULL, run_other, &own), 0);
    run(own.threads[0], 2, run_inner, &own);
    pthread_join(thread, NULL);
    ck_assert_int_eq(own.inner, 40);
    expect_all_done(own.threads[0]); // afterwards, by all threads
    for (int i = 0; i < 2; i++)
        tf_threads_free(own.threads[i]);
}
END_TEST

// The environment --------------------------------------------------------------------

typedef struct rounding {
    atomic_int here, wrong;
    int expected;
} rounding;

static void expect_rounding(void *argument, int task, int worker)
{
    rounding *own = argument;
    (void)task;
    (void)worker;
    meet(&own->here, 3);
    if (fegetround() != own->expected ||
        tf_environment_is_ieee() != (own->expected == FE_TONEAREST))
        atomic_fetch_add(&own->wrong, 1);
}

START_TEST(tasks_have_the_environment_of_the_caller)
{
    static const int modes[] = {FE_TONEAREST, FE_UPWARD, FE_TONEAREST,
                                FE_DOWNWARD};
    ck_assert_int_eq(fesetround(FE_TOWARDZERO), 0);
    tf_threads *threads = pool_of(3);
    for (int i = 0; i < 4; i++) {
        rounding own = {.expected = modes[i]};
        fesetround(modes[i]);
        run(threads, 3, expect_rounding, &own);
        ck_assert_int_eq(own.wrong, 0);
        ck_assert_int_eq(fegetround(), modes[i]);
    }
    fesetround(FE_TONEAREST);
    tf_threads_free(threads);
}
END_TEST

// Processes ----------------------------------------------------------------------------

/// What a copy of the process does with a pool of the process; 0: all is well.
static int use_copy(tf_threads *threads)
{
    atomic_int busy[3] = {0};
    bool good = run_tasks(threads, TASKS, busy);
    tf_threads_free(threads);
#ifndef __SANITIZE_THREAD__ // which cannot follow threads of a copy
    atomic_int here = 0;
    threads = pool_of(3);
    run(threads, 3, meet_three, &here);
    tf_threads_free(threads);
#endif
    return good ? 0 : 1;
}

static void expect_copy_works(tf_threads *threads)
{
    pid_t child = fork();
    if (child == 0) {
        alarm(60);
        _exit(use_copy(threads));
    }
    int status;
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    ck_assert_int_eq(status, 0);
}

START_TEST(pools_survive_a_fork)
{
    tf_threads *threads = pool_of(3);
    expect_copy_works(threads);
    expect_all_done(threads);
    expect_copy_works(threads);
    tf_threads_free(threads);
}
END_TEST

typedef struct held {
    const tf_threads *threads;
    atomic_int here;
    atomic_bool released;
} held;

static void wait_for_release(void *argument, int task, int worker)
{
    held *own = argument;
    (void)task;
    (void)worker;
    meet(&own->here, 2);
    while (!own->released)
        sleep_milliseconds(1);
}

static void *hold(void *argument)
{
    held *own = argument;
    run(own->threads, 2, wait_for_release, own);
    return NULL;
}

START_TEST(pools_survive_a_fork_during_a_call)
{
    tf_threads *threads = pool_of(3);
    held own = {.threads = threads};
    pthread_t thread;
    ck_assert_int_eq(pthread_create(&thread, NULL, hold, &own), 0);
    while (own.here < 2)
        sleep_milliseconds(1);
    expect_copy_works(threads);
    own.released = true;
    pthread_join(thread, NULL);
    expect_all_done(threads);
    tf_threads_free(threads);
}
END_TEST

// Counts -------------------------------------------------------------------------------

START_TEST(threads_that_were_started_do_the_work)
{
    for (int i = 0; i < 5; i++) {
        threads_left = i;
        tf_threads *threads = pool_of(8);
        ck_assert_int_eq(tf_threads_count(threads), 1 + i);
        expect_all_done(threads);
        tf_threads_free(threads);
    }
}
END_TEST

START_TEST(bad_counts_are_refused)
{
    static const int counts[] = {-1, INT_MIN, TF_MOST_THREADS + 1, INT_MAX};
    for (int i = 0; i < 4; i++) {
        tf_threads *threads = (tf_threads *)&threads;
        ck_assert_int_eq(tf_threads_create(counts[i], &threads), TF_BAD_OPTION);
        ck_assert_ptr_null(threads);
    }
}
END_TEST

START_TEST(without_memory_there_is_the_caller)
{
    tf_threads *threads = (tf_threads *)&threads;
    no_memory = true;
    tf_status status = tf_threads_create(2, &threads);
    no_memory = false;
    ck_assert_int_eq(status, TF_OUT_OF_MEMORY);
    ck_assert_ptr_null(threads);
    ck_assert_ptr_null(tf_threads_parallel(NULL));
    ck_assert_int_eq(tf_threads_count(NULL), 1);
    tf_threads_free(NULL);
}
END_TEST

/// The pool has a thread for each processor that this process may use.
START_TEST(usual_number_is_that_of_processors)
{
    cpu_set_t all, few;
    CPU_ZERO(&few);
    ck_assert_int_eq(sched_getaffinity(0, sizeof all, &all), 0);
    for (size_t i = 0; i < CPU_SETSIZE && CPU_COUNT(&few) < 2; i++) {
        if (!CPU_ISSET(i, &all))
            continue;
        CPU_SET(i, &few);
        ck_assert_int_eq(sched_setaffinity(0, sizeof few, &few), 0);
        tf_threads *threads = pool_of(0);
        ck_assert_int_eq(tf_threads_count(threads), CPU_COUNT(&few));
        tf_threads_free(threads);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("threads/threads");
    TCase *tasks = tcase_create("tasks");
    tcase_add_test(tasks, each_task_is_run_once);
    tcase_add_test(tasks, tasks_run_at_once);
    tcase_add_test(tasks, threads_sleep_without_tasks);
    tcase_add_test(tasks, threads_sleep_while_the_last_task_runs);
    suite_add_tcase(suite, tasks);

    TCase *calls = tcase_create("several calls");
    tcase_add_test(calls, calls_take_turns);
    tcase_add_test(calls, tasks_may_run_tasks);
    tcase_add_test(calls, tasks_have_the_environment_of_the_caller);
    suite_add_tcase(suite, calls);

    TCase *processes = tcase_create("processes");
    tcase_add_test(processes, pools_survive_a_fork);
    tcase_add_test(processes, pools_survive_a_fork_during_a_call);
    suite_add_tcase(suite, processes);

    TCase *counts = tcase_create("counts");
    tcase_add_test(counts, threads_that_were_started_do_the_work);
    tcase_add_test(counts, bad_counts_are_refused);
    tcase_add_test(counts, without_memory_there_is_the_caller);
    tcase_add_test(counts, usual_number_is_that_of_processors);
    suite_add_tcase(suite, counts);
    return suite;
}
