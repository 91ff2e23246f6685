// Many queries at once, against single ones, bit for bit.
#include "fast/batch.h"

#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/functions.h"
#include "arithmetic/integer.h"
#include "arithmetic/perturbed.h"
#include "arithmetic/published.h"
#include "query/query.h"
#include "query/shape.h"
#include "support/environments.h"
#include "support/query_batch.h"
#include "support/scrambled_workers.h"
#include "support/statuses.h"
#include "support/support.h"
#include "threads/threads.h"

#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum {
    BATCH = 3000, // more than one task
    TASKS = 1030, // barely more than one
    WAYS = 4
};

static query_kind kind_of(int i)
{
    return i % 2 ? EDGE_EDGE : POINT_TRIANGLE;
}

// Threads ---------------------------------------------------------------------

static int workers = 3;
static tf_threads *threads;

static void begin(void)
{
    ck_assert_int_eq(tf_threads_create(3, &threads), TF_OK);
}

static void finish(void)
{
    tf_threads_free(threads);
}

/// On the caller's thread, on others, or by tasks from the last to the first.
static const tf_parallel *parallel_of(int way)
{
    static tf_parallel scrambled;
    scrambled = scrambled_workers(&workers);
    return way % WAYS == 1   ? tf_threads_parallel(threads)
           : way % WAYS == 2 ? &scrambled
                             : NULL;
}

// Answers ---------------------------------------------------------------------

static tf_contact single(const tf_arithmetic *arithmetic,
                         const tf_queries *queries, size_t i, tf_status *status)
{
    const tf_query_shape *s = tf_query_shape_of(queries->kind);
    const int *vertex =
        queries->vertices + i * (size_t)(s->vertices + s->others);
    tf_contact contact = {0};
    *status =
        tf_query_motion(arithmetic, s->axes, queries->motion, s->vertices,
                        vertex, s->others, vertex + s->vertices, &contact);
    return contact;
}

/// Expects the answers of single queries, and nothing written behind them.
static void expect_same(const tf_arithmetic *arithmetic,
                        const tf_queries *queries, const tf_parallel *parallel)
{
    static tf_contact found[BATCH + 1];
    tf_error error;
    memset(found, 42, sizeof found);
    tf_contact untouched = found[BATCH];
    ck_assert_int_eq(
        tf_query_batch(arithmetic, queries, parallel, found, &error), TF_OK);
    ck_assert_int_eq(error.status, TF_OK);
    for (size_t i = 0; i < queries->count; i++) {
        tf_status status;
        tf_contact expected =
            single(arithmetic ? arithmetic : &tf_exact, queries, i, &status);
        ck_assert_int_eq(status, TF_OK);
        ck_assert_msg(memcmp(&found[i], &expected, sizeof expected) == 0,
                      "query %zu of %zu by %s, seed %llu", i, queries->count,
                      arithmetic ? tf_arithmetic_name(arithmetic) : "default",
                      (unsigned long long)seed());
    }
    for (size_t i = queries->count; i <= BATCH; i++)
        ck_assert_mem_eq(&found[i], &untouched, sizeof untouched);
}

START_TEST(answers_are_those_of_single_queries)
{
    static const tf_arithmetic *const arithmetics[] = {
        &tf_exact, &tf_perturbed, &tf_clamped, &tf_published, NULL};
    generator random = generator_new((uint64_t)_i);
    batch b = batch_new(BATCH);
    for (int k = 0; k < 5; k++) {
        size_t count = 1 + (size_t)below(&random, (int)cases(BATCH - 1));
        batch_fill(&b, &random, &families[_i / 2], kind_of(_i), count);
        expect_same(arithmetics[k], &b.queries, parallel_of(k));
    }
    batch_free(&b);
}
END_TEST

START_TEST(integers_are_answered)
{
    generator random = generator_new(100 + (uint64_t)_i);
    batch b = batch_new(BATCH);
    batch_fill(&b, &random, &families[2], kind_of(_i),
               (size_t)cases_at_least(TASKS, BATCH));
    expect_same(&tf_integer64, &b.queries, parallel_of(_i));
    expect_same(&tf_integer128, &b.queries, parallel_of(_i + 1));
    batch_free(&b);
}
END_TEST

/// Of 100 points and an edge each, on a lattice.
static void fill_plane(generator *random, double start[200], double end[200],
                       int vertex[], int count)
{
    for (int i = 0; i < 200; i++) {
        start[i] = below(random, 5);
        end[i] = below(random, 5);
    }
    for (int i = 0; i < count; i++) {
        vertex[3 * i] = below(random, 50);
        vertex[3 * i + 1] = 50 + below(random, 25);
        vertex[3 * i + 2] = 75 + below(random, 25);
    }
}

START_TEST(queries_in_the_plane_are_answered)
{
    static double start[200], end[200];
    static int vertex[3 * BATCH];
    generator random = generator_new(200 + (uint64_t)_i);
    tf_motion motion = {2, 100, start, end};
    tf_queries queries = {TF_POINT_EDGE, &motion, (size_t)cases(BATCH), vertex};
    fill_plane(&random, start, end, vertex, (int)queries.count);
    expect_same(&tf_exact, &queries, parallel_of(_i));
    expect_same(&tf_perturbed, &queries, parallel_of(_i));
    expect_same(&tf_integer64, &queries, parallel_of(_i));
}
END_TEST

START_TEST(any_number_of_queries_is_answered)
{
    generator random = generator_new(300);
    batch b = batch_new(BATCH);
    batch_fill(&b, &random, &families[2], EDGE_EDGE, BATCH);
    static const size_t counts[] = {0,    1,    63,   64,   65,
                                    1023, 1024, 1025, 2048, BATCH};
    for (int i = 0; i < 10; i++) {
        b.queries.count = counts[i];
        expect_same(NULL, &b.queries, parallel_of(_i));
    }
    batch_free(&b);
}
END_TEST

// Bad queries -----------------------------------------------------------------

/// What is expected of a bad vertex of a batch of queries with vertices of their
/// own.
typedef struct damage {
    size_t query;
    tf_status status;
    int vertex, time; ///< as an error says it
} damage;

/// Spoils a query, at any place.
static damage inflict(generator *random, batch *b, size_t at)
{
    static const double number[] = {NAN, INFINITY, -INFINITY};
    static const int index[] = {-1, INT_MIN, INT_MAX};
    int place = below(random, 4), *vertex = b->vertex + 4 * at;
    damage d = {at, TF_BAD_INDEX, 0, -1};
    if (below(random, 3) == 0) {
        vertex[place] = d.vertex = index[below(random, 3)];
    } else if (below(random, 2) == 0) {
        vertex[place] = d.vertex = vertex[(place + 1) % 4];
    } else {
        d.status = TF_NOT_FINITE;
        d.time = below(random, 2);
        d.vertex = vertex[place];
        (d.time ? b->end : b->start)[3 * d.vertex + below(random, 3)] =
            number[below(random, 3)];
    }
    return d;
}

static void expect_damage(batch *b, const damage *d,
                          const tf_parallel *parallel)
{
    static tf_contact found[BATCH];
    tf_error error;
    b->queries.motion = &b->motion;
    tf_status status =
                  tf_query_batch(NULL, &b->queries, parallel, found, &error),
              alone;
    single(&tf_exact, &b->queries, d->query, &alone);
    ck_assert_int_eq(alone, d->status);
    ck_assert_int_eq(status, d->status);
    ck_assert_int_eq(error.status, d->status);
    ck_assert_int_eq(error.subject, TF_BATCH_QUERY);
    ck_assert_uint_eq(error.index, d->query);
    ck_assert_int_eq(error.vertex[0], d->vertex);
    ck_assert_int_eq(error.time, d->time);
    ck_assert_int_eq(error.vertices,
                     d->status == TF_BAD_INDEX ? b->motion.vertices : 0);
    ck_assert_int_eq(tf_query_batch(NULL, &b->queries, parallel, found, NULL),
                     d->status);
}

START_TEST(the_first_bad_query_is_named)
{
    generator random = generator_new(400 + (uint64_t)_i);
    batch b = batch_new(BATCH);
    for (int i = 0; i < (int)cases(60); i++) {
        size_t count = 1 + (size_t)below(&random, BATCH);
        batch_fill(&b, &random, &families[below(&random, FAMILIES)], kind_of(i),
                   count);
        damage first = {.query = count};
        for (int k = 1 + below(&random, 4); k > 0; k--) {
            size_t at = (size_t)below(&random, (int)count);
            if (at == first.query)
                continue;
            damage d = inflict(&random, &b, at);
            first = d.query < first.query ? d : first;
        }
        expect_damage(&b, &first, parallel_of(_i));
    }
    batch_free(&b);
}
END_TEST

START_TEST(a_bad_query_is_named_at_each_place)
{
    generator random = generator_new(500);
    batch b = batch_new(BATCH);
    size_t count = TASKS, apart = count / (size_t)cases(TASKS);
    batch_fill(&b, &random, &families[0], kind_of(_i), count);
    for (size_t i = (count - 1) % apart; i < count; i += apart) {
        int kept[4];
        double at[2][12];
        memcpy(kept, b.vertex + 4 * i, sizeof kept);
        memcpy(at[0], b.start + 12 * i, sizeof at[0]);
        memcpy(at[1], b.end + 12 * i, sizeof at[1]);
        damage d = inflict(&random, &b, i);
        expect_damage(&b, &d, parallel_of((int)i));
        memcpy(b.vertex + 4 * i, kept, sizeof kept);
        memcpy(b.start + 12 * i, at[0], sizeof at[0]);
        memcpy(b.end + 12 * i, at[1], sizeof at[1]);
    }
    batch_free(&b);
}
END_TEST

/// What to run in the midst of another task.
static struct {
    tf_task *run;
    void *argument;
} interrupting;

static tf_sign interrupted_sign(const tf_differences *differences)
{
    tf_task *run = interrupting.run;
    interrupting.run = NULL;
    if (run)
        run(interrupting.argument, 0, 1);
    return tf_exact.sign(differences);
}

/// Runs the task 1, and in its midst the task 0.
static void run_one_in_another(void *context, int count, tf_task *run,
                               void *argument)
{
    (void)context;
    ck_assert_int_gt(count, 1);
    interrupting.run = run;
    interrupting.argument = argument;
    run(argument, 1, 0);
    ck_assert(!interrupting.run);
}

START_TEST(a_later_bad_query_that_is_found_later_is_not_named)
{
    static tf_contact found[BATCH];
    generator random = generator_new(550);
    tf_arithmetic interrupted = {.name = "interrupted",
                                 .sign = interrupted_sign,
                                 .value = tf_exact.value};
    tf_parallel parallel = {2, run_one_in_another, NULL};
    tf_error error;
    batch b = batch_new(BATCH);
    batch_fill(&b, &random, &families[2], EDGE_EDGE, BATCH);
    b.queries.motion = &b.motion;
    b.vertex[4 * 7] = b.vertex[4 * 2000] = -1;
    ck_assert_int_eq(
        tf_query_batch(&interrupted, &b.queries, &parallel, found, &error),
        TF_BAD_INDEX);
    ck_assert_uint_eq(error.index, 7);
    batch_free(&b);
}
END_TEST

START_TEST(coordinates_out_of_range_are_named)
{
    static const double start[] = {0, 0, 1, 1, 2, 2, 3, 3, 0.5, 4};
    static const double end[] = {0, 0, 1, 1, 2, 2, 0x1p60, 3, 4, 4};
    static const int vertex[] = {0, 1, 2, 1, 2, 3, 4, 1, 2};
    tf_motion motion = {2, 5, start, end};
    tf_queries queries = {TF_POINT_EDGE, &motion, 3, vertex};
    tf_contact found[3];
    tf_error error;
    ck_assert_int_eq(
        tf_query_batch(&tf_integer64, &queries, NULL, found, &error),
        TF_OUT_OF_RANGE);
    ck_assert(error.index == 1 && error.vertex[0] == 3 && error.time == 1);
    queries.vertices += 6;
    queries.count = 1;
    ck_assert_int_eq(
        tf_query_batch(&tf_integer64, &queries, NULL, found, &error),
        TF_OUT_OF_RANGE);
    ck_assert(error.index == 0 && error.vertex[0] == 4 && error.time == 0);
    ck_assert_int_eq(tf_query_batch(NULL, &queries, NULL, found, &error),
                     TF_OK);
}
END_TEST

// Misuse ----------------------------------------------------------------------

static const double x[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
static const int four[] = {0, 1, 2, 3};
static const tf_motion still = {3, 4, x, x};

static tf_status ask(const tf_queries *queries, const tf_parallel *parallel,
                     tf_error *error)
{
    tf_contact contact;
    tf_status status = tf_query_batch(NULL, queries, parallel, &contact, error);
    ck_assert_int_eq(error->status, status);
    return status;
}

START_TEST(what_is_wrong_with_all_queries_is_told)
{
    static const tf_motion flat = {2, 4, x, x}, none = {3, 4, NULL, x};
    const size_t least = SIZE_MAX / 2 / sizeof(tf_contact) + 1;
    tf_parallel idle = {.workers = 0};
    tf_queries good = {TF_EDGE_EDGE, &still, 1, four}, q = good;
    tf_error error;
    ck_assert_int_eq(ask(&good, NULL, &error), TF_OK);
    ck_assert_int_eq(ask(&good, &idle, &error), TF_BAD_OPTION);
    ck_assert_str_eq(error.option, "parallel.workers");
    for (int kind = -1; kind <= TF_EDGE_EDGE + 1; kind++) {
        q.kind = (tf_kind)kind;
        if (kind > TF_NO_KIND && kind <= TF_EDGE_EDGE)
            continue;
        ck_assert_int_eq(ask(&q, NULL, &error), TF_BAD_OPTION);
        ck_assert_str_eq(error.option, "kind");
    }
    q.kind = TF_POINT_EDGE;
    ck_assert_int_eq(ask(&q, NULL, &error), TF_BAD_AXES);
    q = (tf_queries){TF_EDGE_EDGE, &flat, 1, four};
    ck_assert_int_eq(ask(&q, NULL, &error), TF_BAD_AXES);
    q.motion = &none;
    ck_assert_int_eq(ask(&q, NULL, &error), TF_BAD_COUNT);
    q = (tf_queries){TF_EDGE_EDGE, &still, 1, NULL};
    ck_assert_int_eq(ask(&q, NULL, &error), TF_BAD_COUNT);
    const size_t absurd[] = {least, SIZE_MAX / 16, SIZE_MAX};
    for (int i = 0; i < 3; i++) {
        q = (tf_queries){TF_EDGE_EDGE, &still, absurd[i], four};
        ck_assert_int_eq(ask(&q, NULL, &error), TF_BAD_COUNT);
        ck_assert_int_eq(error.subject, TF_NO_SUBJECT);
    }
}
END_TEST

START_TEST(no_queries_are_answered_at_once)
{
    tf_queries none = {.kind = TF_EDGE_EDGE};
    tf_error error;
    ck_assert_int_eq(tf_query_batch(NULL, &none, NULL, NULL, &error), TF_OK);
    ck_assert_int_eq(error.status, TF_OK);
}
END_TEST

/// Counts the tasks, and runs the first ones alone.
static void run_few(void *context, int count, tf_task *run, void *argument)
{
    *(int *)context = count;
    for (int task = 0; task < 3 && task < count; task++)
        run(argument, task, 0);
}

/// The first query is bad, so the others need not even be there.
START_TEST(very_many_queries_are_few_tasks)
{
    if (SIZE_MAX / 2 / sizeof(tf_contact) >> 40 == 0)
        return;
    generator random = generator_new(600);
    batch b = batch_new(BATCH);
    int tasks = 0;
    tf_parallel few = {1, run_few, &tasks};
    tf_error error;
    batch_fill(&b, &random, &families[0], EDGE_EDGE, BATCH);
    b.vertex[0] = -1;
    b.queries.motion = &b.motion;
    for (int i = 20; i <= 40; i += 5) {
        b.queries.count = (size_t)1 << i;
        tf_contact *found = calloc(BATCH, sizeof *found);
        ck_assert_int_eq(tf_query_batch(NULL, &b.queries, &few, found, &error),
                         TF_BAD_INDEX);
        ck_assert_uint_eq(error.index, 0);
        ck_assert_int_gt(tasks, 100);
        ck_assert_int_le(tasks, 1 << 20);
        free(found);
    }
    batch_free(&b);
}
END_TEST

static int broken;

/// Runs tasks in an environment that breaks the proofs.
static void break_and_run(void *context, int count, tf_task *run,
                          void *argument)
{
    (void)context;
    for (int task = 0; task < count; task++) {
        if (task == 1)
            environment_break(broken);
        run(argument, task, 0);
        environment_restore();
    }
}

START_TEST(a_broken_environment_is_reported)
{
    generator random = generator_new(700);
    static tf_contact found[BATCH];
    batch b = batch_new(BATCH);
    tf_parallel worker = {1, break_and_run, NULL};
    tf_error error;
    broken = _i;
    batch_fill(&b, &random, &families[0], EDGE_EDGE, BATCH);
    b.queries.motion = &b.motion;
    environment_break(_i);
    tf_status status = tf_query_batch(NULL, &b.queries, NULL, found, NULL);
    environment_restore();
    ck_assert_int_eq(status, TF_BAD_ENVIRONMENT);
    ck_assert_int_eq(tf_query_batch(NULL, &b.queries, &worker, found, &error),
                     TF_BAD_ENVIRONMENT);
    ck_assert_int_eq(error.subject, TF_NO_SUBJECT);
    batch_free(&b);
}
END_TEST

START_TEST(missing_pointers_break_the_contract)
{
    tf_queries one = {TF_EDGE_EDGE, &still, 1, four};
    tf_queries nowhere = {TF_EDGE_EDGE, NULL, 1, four};
    tf_contact contact;
    exit_on_broken_contract();
    tf_query_batch(NULL,
                   _i == 0   ? NULL
                   : _i == 1 ? &nowhere
                             : &one,
                   NULL, _i == 2 ? NULL : &contact, NULL);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("fast/batch");
    TCase *c = tcase_create("answers");
    tcase_add_checked_fixture(c, begin, finish);
    tcase_add_loop_test(c, answers_are_those_of_single_queries, 0,
                        2 * FAMILIES);
    tcase_add_loop_test(c, integers_are_answered, 0, 2);
    tcase_add_loop_test(c, queries_in_the_plane_are_answered, 0, WAYS);
    tcase_add_loop_test(c, any_number_of_queries_is_answered, 0, WAYS);
    suite_add_tcase(suite, c);

    TCase *bad = tcase_create("bad queries");
    tcase_add_checked_fixture(bad, begin, finish);
    tcase_add_loop_test(bad, the_first_bad_query_is_named, 0, WAYS);
    tcase_add_loop_test(bad, a_bad_query_is_named_at_each_place, 0, 2);
    tcase_add_test(bad, a_later_bad_query_that_is_found_later_is_not_named);
    tcase_add_test(bad, coordinates_out_of_range_are_named);
    suite_add_tcase(suite, bad);

    TCase *misuse = tcase_create("misuse");
    tcase_add_test(misuse, what_is_wrong_with_all_queries_is_told);
    tcase_add_test(misuse, no_queries_are_answered_at_once);
    tcase_add_test(misuse, very_many_queries_are_few_tasks);
    tcase_add_loop_test(misuse, a_broken_environment_is_reported, 0,
                        environments());
    tcase_add_loop_exit_test(misuse, missing_pointers_break_the_contract,
                             BROKEN_CONTRACT, 0, 3);
    suite_add_tcase(suite, misuse);
    return suite;
}
