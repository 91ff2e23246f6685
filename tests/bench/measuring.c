#define _POSIX_C_SOURCE 199309L // clock_gettime

#include "bench/measuring.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

void require(tf_status status)
{
    if (status == TF_OK)
        return;
    fprintf(stderr, "cannot measure: %s\n", tf_status_message(status));
    exit(2);
}

double processor_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}
