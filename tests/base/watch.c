#include "base/watch.h"

#include "support/support.h"

#include <pthread.h>

typedef struct caller {
    int calls, most; ///< how often it is told, and when it has enough
    size_t done, total;
    atomic_int inside;
    bool alone; ///< nobody else was told meanwhile
} caller;

static bool listen(void *context, const tf_stage *stage)
{
    caller *own = context;
    own->alone &= atomic_fetch_add(&own->inside, 1) == 0;
    own->done = stage->done;
    own->total = stage->total;
    bool on = ++own->calls < own->most;
    atomic_fetch_sub(&own->inside, 1);
    return on;
}

START_TEST(without_a_callback_there_is_no_watch)
{
    tf_watch watch;
    ck_assert_ptr_null(tf_watch_begin(&watch, NULL, NULL));
    ck_assert(tf_watch_done(NULL, 1));
    ck_assert(!tf_watch_cancelled(NULL));
    tf_watch_stage(NULL, "nothing", 1);
}
END_TEST

START_TEST(caller_is_told_and_cancels_for_good)
{
    tf_watch storage;
    caller own = {.most = 3, .alone = true};
    tf_watch *watch = tf_watch_begin(&storage, listen, &own);
    tf_watch_stage(watch, "pairs", 10);
    ck_assert(tf_watch_done(watch, 4));
    ck_assert_uint_eq(own.done, 4);
    ck_assert_uint_eq(own.total, 10);
    ck_assert(tf_watch_done(watch, 2));
    ck_assert_uint_eq(own.done, 6);
    ck_assert(!tf_watch_cancelled(watch));
    ck_assert(!tf_watch_done(watch, 1));
    ck_assert(tf_watch_cancelled(watch));
    tf_watch_stage(watch, "more", 1);
    ck_assert(!tf_watch_done(watch, 1));
    ck_assert_int_eq(own.calls, 3);
}
END_TEST

START_TEST(loops_tell_now_and_then)
{
    tf_watch storage;
    caller own = {.most = 3, .alone = true};
    ck_assert(tf_watch_work(NULL, 1 << 30));
    tf_watch *watch = tf_watch_begin(&storage, listen, &own);
    tf_watch_stage(watch, "rows", 10);
    tf_watch_advance(watch, 6);
    tf_watch_advance(NULL, 6);
    ck_assert_int_eq(own.calls, 0);
    for (int i = 1; i < TF_WATCHED_WORK; i++)
        ck_assert(tf_watch_work(watch, 1));
    ck_assert_int_eq(own.calls, 0);
    ck_assert(tf_watch_work(watch, 1));
    ck_assert_int_eq(own.calls, 1);
    ck_assert_uint_eq(own.done, 6);
    // However much it is, it is told at once, and once.
    ck_assert(tf_watch_work(watch, 10 * TF_WATCHED_WORK));
    ck_assert_int_eq(own.calls, 2);
    ck_assert_int_eq(tf_watch_failure(watch), TF_OUT_OF_MEMORY);
    ck_assert(!tf_watch_work(watch, TF_WATCHED_WORK));
    ck_assert(!tf_watch_work(watch, 0));
    ck_assert_int_eq(tf_watch_failure(watch), TF_CANCELLED);
    ck_assert_int_eq(tf_watch_failure(NULL), TF_OUT_OF_MEMORY);
}
END_TEST

START_TEST(no_more_is_done_than_there_is)
{
    tf_watch storage;
    caller own = {.most = 9};
    tf_watch *watch = tf_watch_begin(&storage, listen, &own);
    tf_watch_stage(watch, "batches of eight", 10);
    tf_watch_done(watch, 8);
    ck_assert_uint_eq(own.done, 8);
    tf_watch_done(watch, 8);
    ck_assert_uint_eq(own.done, 10);
    tf_watch_stage(watch, "nobody knows how many", 0);
    tf_watch_done(watch, 8);
    ck_assert_uint_eq(own.done, 8);
}
END_TEST

enum {
    THREADS = 4,
    TIMES = 20000
};

static void *work(void *argument)
{
    for (int i = 0; i < TIMES; i++)
        tf_watch_done(argument, 1);
    return NULL;
}

START_TEST(threads_tell_one_at_a_time)
{
    tf_watch storage;
    caller own = {.most = 1 << 30, .alone = true};
    tf_watch *watch = tf_watch_begin(&storage, listen, &own);
    pthread_t thread[THREADS];
    for (int i = 0; i < THREADS; i++)
        ck_assert_int_eq(pthread_create(&thread[i], NULL, work, watch), 0);
    for (int i = 0; i < THREADS; i++)
        pthread_join(thread[i], NULL);
    ck_assert(own.alone && own.calls > 0);
    tf_watch_done(watch, 1);
    ck_assert_uint_eq(own.done, (size_t)THREADS * TIMES + 1);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("base/watch");
    TCase *tcase = tcase_create("watch");
    tcase_add_test(tcase, without_a_callback_there_is_no_watch);
    tcase_add_test(tcase, caller_is_told_and_cancels_for_good);
    tcase_add_test(tcase, no_more_is_done_than_there_is);
    tcase_add_test(tcase, threads_tell_one_at_a_time);
    tcase_add_test(tcase, loops_tell_now_and_then);
    suite_add_tcase(suite, tcase);
    return suite;
}
