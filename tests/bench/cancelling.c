// How soon long calls return after their callback has said false, at random
// moments.
//
//     cancelling [MOMENTS [SECONDS [THREADS [NAME]]]]
//
// at so many moments of the first SECONDS of each call, or of those whose names
// begin with NAME.  Prints the lines of bench/latency.h.
#include "bench/long_calls.h"
#include "bench/measuring.h"
#include "threads/threads.h"

#include <stdlib.h>
#include <string.h>

static void print(const long_call *calls, const char *name,
                  const latency_plan *plan)
{
    for (int i = 0; calls[i].name; i++)
        if (strncmp(calls[i].name, name, strlen(name)) == 0)
            latency_print(&calls[i], plan);
}

int main(int count, char *argument[])
{
    latency_plan plan = {.moments = count > 1 ? atoi(argument[1]) : 100,
                         .seconds = count > 2 ? atof(argument[2]) : 10};
    const char *name = count > 4 ? argument[4] : "";
    tf_threads *threads = NULL;
    if (count > 3 && atoi(argument[3]) > 1)
        require(tf_threads_create(atoi(argument[3]), &threads));
    plan.parallel = tf_threads_parallel(threads);
    print(surface_calls, name, &plan);
    print(adaptive_calls, name, &plan);
    tf_threads_free(threads);
    return 0;
}
