// Threads that answer queries at the same time find what one thread finds, to
// the last bit.
#define _POSIX_C_SOURCE 200809L // pthread_barrier_t

#include "threads/threads.h"
#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/integer.h"
#include "arithmetic/perturbed.h"
#include "arithmetic/published.h"
#include "base/contract.h"
#include "query/edge_edge.h"
#include "query/narrow_phase.h"
#include "query/point_edge.h"
#include "query/point_triangle.h"
#include "support/queries.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

enum {
    THREADS = 8,
    ARITHMETICS = 6,
    COORDINATES = 2 * QUERY_VERTICES * TF_AXES
};

static const tf_arithmetic *const arithmetics[ARITHMETICS] = {
    &tf_exact,     &tf_clamped,   &tf_published,
    &tf_perturbed, &tf_integer64, &tf_integer128,
};

// Answers ---------------------------------------------------------------------

/// What all arithmetics answer to a query, compared byte by byte.
typedef struct answer {
    tf_status status[ARITHMETICS];
    tf_verdict decided[ARITHMETICS]; ///< by the narrow phase
    tf_contact contact[ARITHMETICS];
} answer;

static tf_status ask(const tf_arithmetic *arithmetic, tf_kind kind,
                     const tf_motion *motion, const int vertices[],
                     tf_contact *contact)
{
    switch (kind) {
    case TF_POINT_EDGE:
        return tf_point_edge(arithmetic, motion, vertices[0], vertices + 1,
                             contact);
    case TF_POINT_TRIANGLE:
        return tf_point_triangle(arithmetic, motion, vertices[0], vertices + 1,
                                 contact);
    default:
        return tf_edge_edge(arithmetic, motion, vertices, vertices + 2,
                            contact);
    }
}

static tf_kind kind_of(const query *q)
{
    if (q->axes == 2)
        return TF_POINT_EDGE;
    return q->vertices == 1 ? TF_POINT_TRIANGLE : TF_EDGE_EDGE;
}

static void find_answer(query q, answer *found)
{
    static const int vertices[QUERY_VERTICES] = {0, 1, 2, 3};
    double x[COORDINATES];
    int size = query_size(&q);
    for (int i = 0; i < size; i++)
        x[i] = *query_coordinate(&q, i);
    tf_motion motion = {q.axes, q.vertices + q.others, x, x + size / 2};
    tf_queries queries = {kind_of(&q), &motion, 1, vertices};

    memset(found, 0, sizeof *found);
    for (int i = 0; i < ARITHMETICS; i++) {
        found->status[i] = ask(arithmetics[i], queries.kind, &motion, vertices,
                               &found->contact[i]);
        tf_reference.decide(NULL, arithmetics[i], &queries, &found->decided[i],
                            &(size_t){0});
    }
}

// Threads ---------------------------------------------------------------------

/// Runs a task on each of as many threads.  They start together, as they wait
/// for each other at the barrier of the tasks.
static void run_at_once(tf_task *run, void *argument)
{
    tf_threads *threads;
    ck_assert_int_eq(tf_threads_create(THREADS, &threads), TF_OK);
    ck_assert_int_eq(tf_threads_count(threads), THREADS);
    const tf_parallel *parallel = tf_threads_parallel(threads);
    parallel->for_each(parallel->context, THREADS, run, argument);
    tf_threads_free(threads);
}

/// The same queries for all threads.
typedef struct work {
    int count;
    query *queries;
    pthread_barrier_t start;
    answer *answers[THREADS]; ///< of each thread, by query
} work;

static void shuffle(generator *random, int count, int order[])
{
    for (int i = 0; i < count; i++) {
        int other = below(random, i + 1);
        order[i] = order[other];
        order[other] = i;
    }
}

/// A thread has an order of its own.
static void answer_all(void *argument, int task, int worker)
{
    work *shared = argument;
    size_t count = (size_t)shared->count;
    answer *answers = shared->answers[task] = malloc(count * sizeof *answers);
    generator random = generator_new(100 + (uint64_t)task);
    int *order = malloc(count * sizeof *order);
    shuffle(&random, shared->count, order);

    (void)worker;
    pthread_barrier_wait(&shared->start);
    for (size_t i = 0; i < count; i++)
        find_answer(shared->queries[order[i]], &answers[order[i]]);
    free(order);
}

static void expect_same(const work *shared, int thread)
{
    for (int i = 0; i < shared->count; i++) {
        answer alone;
        find_answer(shared->queries[i], &alone);
        if (memcmp(&alone, &shared->answers[thread][i], sizeof alone) != 0)
            ck_abort_msg("thread %d has another answer\nseed %llu, %s\n%s",
                         thread, (unsigned long long)seed(),
                         query_name(&shared->queries[i]),
                         query_text(&shared->queries[i]));
    }
}

// Tests -----------------------------------------------------------------------

/// Some of small integers, which every arithmetic takes.
static query make_query(generator *random, int number)
{
    query_kind kind = (query_kind)below(random, KINDS);
    switch (number % 3) {
    case 0:
        return query_lattice(random, kind, 4);
    case 1:
        return query_extreme(random, kind);
    default:
        return query_any(random, kind);
    }
}

static void make_queries(work *shared)
{
    generator random = generator_new(99);
    shared->queries = malloc((size_t)shared->count * sizeof *shared->queries);
    for (int i = 0; i < shared->count; i++)
        shared->queries[i] = make_query(&random, i);
}

START_TEST(threads_find_the_same_answers)
{
    work shared = {.count = (int)cases(3000)};
    make_queries(&shared);
    pthread_barrier_init(&shared.start, NULL, THREADS);
    run_at_once(answer_all, &shared);
    for (int i = 0; i < THREADS; i++) {
        expect_same(&shared, i);
        free(shared.answers[i]);
    }
    pthread_barrier_destroy(&shared.start);
    free(shared.queries);
}
END_TEST

static void ignore(const char *file, int line, const char *condition)
{
    (void)file;
    (void)line;
    (void)condition;
}

static void replace_handler(void *argument, int task, int worker)
{
    (void)task;
    (void)worker;
    pthread_barrier_wait(argument);
    for (int i = 0; i < 1000; i++)
        tf_contract_set_handler(i % 2 ? ignore : NULL);
}

// For ThreadSanitizer to find fault with.
START_TEST(threads_replace_the_handler)
{
    pthread_barrier_t start;
    pthread_barrier_init(&start, NULL, THREADS);
    run_at_once(replace_handler, &start);
    ck_assert(tf_contract_set_handler(NULL) == ignore);
    pthread_barrier_destroy(&start);
}
END_TEST

Suite *suite(void)
{
    Suite *threads = suite_create("threads");
    TCase *together = tcase_create("together");
    tcase_add_test(together, threads_find_the_same_answers);
    tcase_add_test(together, threads_replace_the_handler);
    suite_add_tcase(threads, together);
    return threads;
}
