//: Declare the serial default
#pragma once

#include "base/error.h"
#include "surface/parallel.h"

/// Whether there are threads to use: TF_OK, also if `parallel` is NULL, or
/// TF_BAD_OPTION.
tf_status tf_parallel_check(const tf_parallel *parallel, tf_error *error);

/// Runs the tasks as `parallel` does, or one after another if it is NULL.
void tf_parallel_for_each(const tf_parallel *parallel, int count, tf_task *run,
                          void *argument);

/// How many workers there are, if they are good; 1 if `parallel` is NULL.
int tf_parallel_workers(const tf_parallel *parallel);

//: Declare how to divide a range
/// A part of a range of items.
typedef struct tf_range {
    int begin; ///< the first item
    int end;   ///< one more than the last
} tf_range;

/// The size of the parts when a range is divided into at most `parts`, each but
/// the last of at least `least` items.
int tf_range_size(int count, int parts, int least);

/// How many parts of at most `size` items a range of `count` has.
int tf_range_parts(int count, int size);

/// One of those parts.
tf_range tf_range_part(int count, int size, int part);
