//: Run tasks in parallel
#include "surface/tasks.h"

#include "base/fail.h"

#include <stddef.h>

enum {
    MOST_WORKERS = 4096
};

tf_status tf_parallel_check(const tf_parallel *parallel, tf_error *error)
{
    if (parallel && (parallel->workers < 1 || parallel->workers > MOST_WORKERS))
        return tf_fail_option(error, "parallel.workers", "from 1 to 4096",
                              parallel->workers);
    if (parallel && !parallel->for_each)
        return tf_fail_option(error, "parallel.for_each", "a function", 0);
    return TF_OK;
}

int tf_parallel_workers(const tf_parallel *parallel)
{
    return parallel ? parallel->workers : 1;
}

void tf_parallel_for_each(const tf_parallel *parallel, int count, tf_task *run,
                          void *argument)
{
    if (parallel && count > 1) {
        parallel->for_each(parallel->context, count, run, argument);
        return;
    }
    for (int task = 0; task < count; task++)
        run(argument, task, 0);
}

//: Divide a range
int tf_range_parts(int count, int size)
{
    return count / size + (count % size != 0);
}

int tf_range_size(int count, int parts, int least)
{
    int size = tf_range_parts(count, parts);
    return size < least ? least : size;
}

tf_range tf_range_part(int count, int size, int part)
{
    int begin = part * size;
    return (tf_range){begin, count - begin < size ? count : begin + size};
}
