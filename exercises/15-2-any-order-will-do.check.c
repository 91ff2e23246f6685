#include "check.h"

#include "bench/layers.h"
#include "support/support.h"
#include "surface/detect.h"

#include <stdlib.h>
#include <string.h>

enum {
    TASKS = 100,
    WORKERS = 8
};

void adverse(void *context, int count, tf_task *run, void *argument);

/// What is known of the tasks that have run.
typedef struct record {
    int count, workers;
    int runs[TASKS], of_worker[WORKERS];
    int last;
    bool backward; ///< whether one has run before one with a lower number
} record;

static void note(void *argument, int task, int worker)
{
    record *all = argument;
    check_that(task >= 0 && task < all->count, "a task from 0 to count - 1",
               "task %d of %d", task, all->count);
    check_that(worker >= 0 && worker < all->workers,
               "a worker from 0 to workers - 1", "worker %d of %d", worker,
               all->workers);
    check_that(++all->runs[task] == 1, "every task once", "task %d again",
               task);
    all->of_worker[worker]++;
    all->backward |= task < all->last;
    all->last = task;
}

static void expect_tasks(int count, int workers)
{
    record all = {.count = count, .workers = workers};
    check_input("%d tasks, %d workers", count, workers);
    check_call(all, adverse(&workers, count, note, &all));
    for (int task = 0; task < count; task++)
        check_that(all.runs[task] == 1, "every task once", "no task %d", task);
    check_that(count < 4 || all.backward, "tasks in another order",
               "the natural order");
    for (int i = 0; i < workers; i++)
        check_that(count < workers || all.of_worker[i] > 0,
                   "a task for every worker", "none for worker %d", i);
}

TEST(every_task_runs_once)
{
    for (int workers = 1; workers <= WORKERS; workers++)
        for (int count = 1; count <= TASKS; count += 1 + count / 4)
            expect_tasks(count, workers);
}

static tf_surface *new_surface(const tf_mesh *mesh)
{
    tf_surface *surface = NULL;
    tf_status status = tf_surface_create(mesh, &surface, NULL);
    check_that(status == TF_OK, "memory", "%s", tf_status_message(status));
    return surface;
}

/// With elements enough for many tasks.
TEST(a_detection_gives_the_same_rows)
{
    layers cloth = layers_new(30, 1, 1);
    tf_surface *one = new_surface(&cloth.mesh);
    tf_surface *several = new_surface(&cloth.mesh);
    tf_contacts expected, found;
    tf_status status = tf_detect(one, &cloth.motion, NULL, &expected, NULL);
    tf_surface_contact *row = malloc(expected.count * sizeof *row);
    check_that(status == TF_OK && row, "memory", "none");
    for (int workers = 1; workers <= WORKERS; workers++) {
        tf_parallel parallel = {workers, adverse, &workers};
        tf_detect_options detection = {.parallel = &parallel};
        check_input("a step with %zu contacts, %d workers", expected.count,
                    workers);
        check_call(found.count,
                   tf_detect(several, &cloth.motion, &detection, &found, NULL));
        check_that(found.count == expected.count, "as many contacts", "%zu",
                   found.count);
        check_call_n(found.count, row,
                     memcpy(row, found.contact, sizeof *row * found.count));
        check_that(memcmp(row, expected.contact, sizeof *row * found.count) ==
                       0,
                   "the same rows", "others");
    }
    free(row);
    tf_surface_free(one);
    tf_surface_free(several);
    layers_free(&cloth);
}

void run_tests(void)
{
    check_run(1, every_task_runs_once);
    check_run(1, a_detection_gives_the_same_rows);
}
