// Run tasks on the threads of a pool: a user's program, in C and C++.
#include <stdio.h>
#include <string.h>
#include <tanglefree_threads.h>

enum {
    TASKS = 1000
};

static void note(void *argument, int task, int worker)
{
    int *done = (int *)argument;
    done[task] = worker >= 0 && worker < 3 ? task + 1 : 0;
}

int main(void)
{
    static int done[TASKS];
    tf_threads *threads;
    tf_status status = tf_threads_create(3, &threads);
    if (status != TF_OK || strcmp(tf_version(), TF_VERSION) != 0) {
        puts(tf_status_message(status));
        return 1;
    }
    const tf_parallel *parallel = tf_threads_parallel(threads);
    parallel->for_each(parallel->context, TASKS, note, done);
    int sum = 0;
    for (int i = 0; i < TASKS; i++)
        sum += done[i] == i + 1;
    printf("%d tasks by %d threads\n", sum, tf_threads_count(threads));
    tf_threads_free(threads);
    return 0;
}
