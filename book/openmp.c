#include <omp.h>
#include <tanglefree.h>

static void for_each(void *context, int count, tf_task *run, void *argument)
{
    (void)context;
#pragma omp parallel for schedule(dynamic)
    for (int task = 0; task < count; task++)
        run(argument, task, omp_get_thread_num());
}

tf_parallel openmp(void)
{
    return (tf_parallel){omp_get_max_threads(), for_each, NULL};
}
