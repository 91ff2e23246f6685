// Workers: what they find, and how they stop.
#include "surface/workers.h"

#include "support/scrambled_workers.h"
#include "support/support.h"
#include "support/watches.h"

#include <string.h>

static void *add(tf_worker *worker, int value)
{
    int *row = tf_worker_add(worker, sizeof *row);
    ck_assert_ptr_nonnull(row);
    ck_assert_int_eq(*row, 0);
    *row = value;
    return row;
}

START_TEST(rows_stay_and_are_forgotten)
{
    tf_workers workers = {0};
    int job;
    for (int round = 0; round < 3; round++) {
        ck_assert(tf_workers_begin(&workers, 2 + round, &job));
        ck_assert_uint_eq(tf_workers_rows(&workers), 0);
        for (int i = 0; i < 1000; i++)
            add(workers.worker[i % 2], i + 1);
        ck_assert_uint_eq(tf_workers_rows(&workers), 1000);
        for (int i = 0; i < 1000; i++) {
            tf_worker *own = workers.worker[i % 2];
            ck_assert_ptr_eq(own->job, &job);
            ck_assert_int_eq(own->number, i % 2);
            ck_assert_int_eq(((int *)own->row.data)[i / 2], i + 1);
        }
    }
    ck_assert_uint_gt(tf_workers_memory(&workers), 1000 * sizeof(int));
    tf_workers_free(&workers);
    ck_assert_uint_eq(tf_workers_memory(&workers), 0);
}
END_TEST

START_TEST(the_first_bad_status_counts)
{
    tf_workers workers = {0};
    ck_assert(tf_workers_begin(&workers, 3, NULL));
    ck_assert_int_eq(tf_workers_status(&workers), TF_OK);
    workers.worker[2]->status = TF_NOT_FINITE;
    ck_assert_int_eq(tf_workers_status(&workers), TF_NOT_FINITE);
    workers.worker[1]->status = TF_OUT_OF_MEMORY;
    ck_assert_int_eq(tf_workers_status(&workers), TF_OUT_OF_MEMORY);
    ck_assert(tf_workers_begin(&workers, 3, NULL));
    ck_assert_int_eq(tf_workers_status(&workers), TF_OK);
    tf_workers_free(&workers);
}
END_TEST

static bool is_less(const void *a, const void *b)
{
    return *(const int *)a < *(const int *)b;
}

// Whichever worker has found them.
START_TEST(rows_are_gathered_in_order)
{
    tf_workers workers = {0};
    tf_buffer sorting = {0}, found = {0};
    watched_call call;
    generator random = generator_new(3);
    for (int rows = 0; rows < 3000; rows = 3 * rows + 1) {
        ck_assert(tf_workers_begin(&workers, 4, NULL));
        for (int i = 0; i < rows; i++) // 7 and 3001 have no common divisor
            add(workers.worker[below(&random, 3)], 1 + i * 7 % 3001);
        ck_assert_int_eq(
            tf_workers_gather(&workers, sizeof(int), is_less, &sorting, &found),
            TF_OK);
        const int *all = found.data;
        for (int i = 1; i < rows; i++)
            ck_assert_int_lt(all[i - 1], all[i]);
        long sum = 0, expected = 0;
        for (int i = 0; i < rows; i++) {
            sum += all[i];
            expected += 1 + i * 7 % 3001;
        }
        ck_assert_int_eq(sum, expected);
    }
    workers.watch = watched_begin(&call, -1);
    ck_assert_int_eq(
        tf_workers_gather(&workers, sizeof(int), is_less, &sorting, &found),
        TF_CANCELLED);
    tf_buffer_free(&sorting);
    tf_buffer_free(&found);
    tf_workers_free(&workers);
}
END_TEST

// Joins -----------------------------------------------------------------------

enum {
    POINTS = 5000
};

static tf_path point[POINTS];

/// Points in two places, in a tree: each has half of the others as candidates.
static void build(tf_tree *tree)
{
    tf_box whole = {.high = {1}};
    for (int i = 0; i < POINTS; i++)
        point[i].at[0] = point[i].at[TF_AXES] = (float)(i % 2);
    tf_tree_workspace workspace = {0};
    tf_tree_elements elements = {
        .count = POINTS, .corners = 1, .vertex = point, .whole = &whole};
    ck_assert(tf_tree_build(tree, &elements, &workspace, NULL));
    tf_tree_workspace_free(&workspace);
}

static int batches;

/// Counts pairs as rows, without keeping them.
static bool count(tf_pair_sink *sink, int pairs, const tf_candidate pair[])
{
    tf_worker *worker = (tf_worker *)sink;
    (void)pair;
    worker->rows += (size_t)pairs;
    batches++;
    return !worker->job;
}

START_TEST(workers_share_a_join)
{
    tf_tree tree = {0};
    build(&tree);
    tf_workers workers = {0};
    int threads = 3;
    tf_parallel parallel = scrambled_workers(&threads);
    ck_assert(tf_workers_begin(&workers, threads, NULL));
    tf_workers_join(&workers, &tree, &tree, count, NULL, &parallel);
    size_t half = POINTS / 2;
    ck_assert_uint_eq(tf_workers_rows(&workers), half * (half - 1));
    for (int i = 0; i < threads; i++)
        ck_assert_uint_gt(workers.worker[i]->rows, 0);

    // A job that wants no more ends with one batch.
    ck_assert(tf_workers_begin(&workers, threads, &tree));
    batches = 0;
    tf_workers_join(&workers, &tree, &tree, count, NULL, &parallel);
    ck_assert_int_eq(batches, 1);
    tf_workers_free(&workers);
    tf_tree_free(&tree);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surface/workers");
    TCase *tcase = tcase_create("workers");
    tcase_add_test(tcase, rows_stay_and_are_forgotten);
    tcase_add_test(tcase, the_first_bad_status_counts);
    tcase_add_test(tcase, rows_are_gathered_in_order);
    tcase_add_test(tcase, workers_share_a_join);
    suite_add_tcase(suite, tcase);
    return suite;
}
