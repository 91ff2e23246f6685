#include "support/scrambled_workers.h"

static void for_each(void *context, int count, tf_task *run, void *argument)
{
    const int *workers = context;
    for (int task = count - 1; task >= 0; task--)
        run(argument, task, task % *workers);
}

tf_parallel scrambled_workers(const int *workers)
{
    return (tf_parallel){*workers, for_each, (int *)workers};
}
