// Workers as adverse as can be without threads: tasks in another order, each by
// another worker.
#ifndef SUPPORT_SCRAMBLED_H
#define SUPPORT_SCRAMBLED_H

#include "surface/parallel.h"

/// How to run tasks, the last first, by `*workers` in turn; borrows the number.
tf_parallel scrambled(const int *workers);

#endif
