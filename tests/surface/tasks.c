// Tasks and ranges.
#include "surface/tasks.h"

#include "support/scrambled_workers.h"
#include "support/support.h"

#include <limits.h>
#include <signal.h>
#include <string.h>

enum {
    TASKS = 50
};

/// How often each task ran, and the largest number of a worker.
typedef struct record {
    int runs[TASKS], last_worker;
} record;

static void note(void *argument, int task, int worker)
{
    record *all = argument;
    ck_assert_int_ge(worker, 0);
    all->runs[task]++;
    all->last_worker = worker > all->last_worker ? worker : all->last_worker;
}

static record run(const tf_parallel *parallel, int count)
{
    record all = {{0}, 0};
    tf_parallel_for_each(parallel, count, note, &all);
    for (int i = 0; i < TASKS; i++)
        ck_assert_int_eq(all.runs[i], i < count);
    return all;
}

START_TEST(every_task_runs_once)
{
    static const int counts[] = {0, 1, 2, TASKS};
    int workers = 3;
    tf_parallel parallel = scrambled_workers(&workers);
    for (int i = 0; i < 4; i++) {
        ck_assert_int_eq(run(NULL, counts[i]).last_worker, 0);
        run(&parallel, counts[i]);
    }
    ck_assert_int_eq(run(&parallel, TASKS).last_worker, workers - 1);
    ck_assert_int_eq(tf_parallel_workers(&parallel), workers);
    ck_assert_int_eq(tf_parallel_workers(NULL), 1);
}
END_TEST

START_TEST(threads_that_are_none_are_refused)
{
    static const int bad[] = {0, -1, 4097, INT_MAX, INT_MIN},
                     good[] = {1, 4096};
    tf_error error;
    int workers = 1;
    tf_parallel parallel = scrambled_workers(&workers);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        parallel.workers = bad[i];
        ck_assert_int_eq(tf_parallel_check(&parallel, &error), TF_BAD_OPTION);
        ck_assert_str_eq(error.option, "parallel.workers");
        ck_assert_double_eq(error.value, bad[i]);
    }
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        parallel.workers = good[i];
        ck_assert_int_eq(tf_parallel_check(&parallel, &error), TF_OK);
    }
    ck_assert_int_eq(tf_parallel_check(NULL, &error), TF_OK);
    parallel.for_each = NULL;
    ck_assert_int_eq(tf_parallel_check(&parallel, &error), TF_BAD_OPTION);
    ck_assert_str_eq(error.option, "parallel.for_each");
}
END_TEST

START_TEST(parts_cover_a_range_once)
{
    static const int counts[] = {0, 1, 15, 16, 17, 1000, INT_MAX};
    static const int sizes[] = {1, 16, 999, 1000, 1001, 1 << 30};
    for (int i = 0; i < 7; i++)
        for (int j = counts[i] == INT_MAX ? 5 : 0; j < 6; j++) {
            int parts = tf_range_parts(counts[i], sizes[j]), next = 0;
            for (int part = 0; part < parts; part++) {
                tf_range range = tf_range_part(counts[i], sizes[j], part);
                ck_assert_int_eq(range.begin, next);
                ck_assert_int_gt(range.end, range.begin);
                ck_assert_int_le(range.end - range.begin, sizes[j]);
                next = range.end;
            }
            ck_assert_int_eq(next, counts[i]);
        }
}
END_TEST

START_TEST(ranges_are_divided_into_few_parts_of_many)
{
    static const struct {
        int count, parts, least, size;
    } row[] = {
        {0, 4, 10, 10},  {1, 4, 10, 10},
        {40, 4, 10, 10}, {41, 4, 10, 11},
        {44, 4, 10, 11}, {45, 4, 10, 12},
        {45, 1, 10, 45}, {INT_MAX, 64, 16384, 1 << 25},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        ck_assert_int_eq(
            tf_range_size(row[i].count, row[i].parts, row[i].least),
            row[i].size);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surface/tasks");
    TCase *tcase = tcase_create("tasks");
    tcase_add_test(tcase, every_task_runs_once);
    tcase_add_test(tcase, threads_that_are_none_are_refused);
    tcase_add_test(tcase, parts_cover_a_range_once);
    tcase_add_test(tcase, ranges_are_divided_into_few_parts_of_many);
    suite_add_tcase(suite, tcase);
    return suite;
}
