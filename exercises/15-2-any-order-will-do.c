/* Exercise 15.2.  Any order will do: an adverse scheduler of tasks.
 *
 * Write the `for_each` of a tf_parallel that is as adverse as a system of
 * threads can be, without threads: it runs every task once, but not in order,
 * and each on some worker.  The context points to the number of workers, from 1
 * to 8.  When there are at least four tasks, some task has to run before one
 * with a lower number; when there are as many tasks as workers or more, every
 * worker has to run one.
 *
 * Section: The caller's threads.
 *
 * Hint 1: The simplest order other than the natural one is the reverse.
 * Hint 2: `worker` selects the memory in which a task keeps what it finds.  A
 *     number that is not below the number of workers selects memory of nobody.
 * Hint 3: task % workers is a worker for each task.
 */
#include "surface/parallel.h"

void adverse(void *context, int count, tf_task *run, void *argument)
{
    int workers = *(const int *)context;
#if defined TF_SOLUTION
    for (int task = count - 1; task >= 0; task--)
        run(argument, task, task % workers);
#elif defined TF_WRONG_1 // forgets task 0
    for (int task = count - 1; task > 0; task--)
        run(argument, task, task % workers);
#elif defined TF_WRONG_2 // gives every task a worker of its own
    for (int task = count - 1; task >= 0; task--)
        run(argument, task, task + 0 * workers);
#elif defined TF_WRONG_3 // runs the first task again
    for (int task = count; task >= 0; task--)
        run(argument, task % count, task % workers);
#elif defined TF_WRONG_4 // leaves all work to one worker
    for (int task = count - 1; task >= 0; task--)
        run(argument, task, 0 * workers);
#else
    // Your turn: this order is too tame, and the others have nothing to do.
    for (int task = 0; task < count; task++)
        run(argument, task, 0 * workers);
#endif
}
