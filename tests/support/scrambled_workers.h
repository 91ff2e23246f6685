// Workers as adverse as can be without threads: tasks in another order, each by
// another worker.
#ifndef SUPPORT_SCRAMBLED_WORKERS_H
#define SUPPORT_SCRAMBLED_WORKERS_H

#include "surface/parallel.h"

/// How to run tasks, the last first, by `*workers` in turn; borrows the number.
tf_parallel scrambled_workers(const int *workers);

#endif
