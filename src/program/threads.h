//: Declare the threads of the program
#pragma once

#include "surface/parallel.h"

enum {
    TF_MOST_THREADS = 256
};

/// How many threads the machine runs at once, at most TF_MOST_THREADS.
int tf_threads_available(void);

/// How to run tasks on `*count` threads, from 1 to TF_MOST_THREADS; borrows the
/// number.
tf_parallel tf_threads(const int *count);
