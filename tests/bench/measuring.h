// What programs that measure have in common.
#ifndef BENCH_MEASURING_H
#define BENCH_MEASURING_H

#include "base/status.h"

/// Ends the program with a message unless the status is TF_OK.
void require(tf_status status);

/// How long the processors have worked for this program.
double processor_seconds(void);

#endif
