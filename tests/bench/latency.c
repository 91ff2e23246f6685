#define _POSIX_C_SOURCE 199309L // clock_gettime

#include "bench/latency.h"

#include "bench/measuring.h"
#include "support/generator.h"
#include "support/memory.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

// A call that is timed --------------------------------------------------------

typedef struct stopwatch {
    bool by_processor;
    double begin, last, told;
    double moment; ///< to cancel; INFINITY: never
    double silence;
    const char *silent_stage, *stage;
    long calls;
} stopwatch;

static double seconds(const stopwatch *w)
{
    if (w->by_processor)
        return processor_seconds();
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/// Notes how long there was no call of the callback; returns the time.
static double end_silence(stopwatch *w)
{
    double now = seconds(w), silence = now - w->last;
    if (silence > w->silence) {
        w->silence = silence;
        w->silent_stage = w->stage;
    }
    w->last = now;
    return now;
}

static bool tell(void *context, const tf_stage *stage)
{
    stopwatch *w = context;
    double now = end_silence(w);
    w->calls++;
    w->stage = stage->name;
    if (now - w->begin < w->moment)
        return true;
    w->told = seconds(w);
    return false;
}

/// Returns how long it took to return, once it was cancelled.  A call that was
/// not may have changed the scene, which is made anew.
static double time_call(const long_call *call, void **scene,
                        const latency_plan *plan, stopwatch *w)
{
    watched how = {plan->parallel, tell, w};
    w->by_processor = !plan->parallel;
    w->stage = "the beginning";
    w->begin = w->last = w->told = seconds(w);
    tf_status status = call->run(*scene, call->variant, &how);
    double end = end_silence(w);
    if (status == TF_CANCELLED)
        return end - w->told;
    require(status);
    call->release(*scene);
    *scene = call->make(call->variant);
    return 0;
}

// Many moments ----------------------------------------------------------------

static int compare(const void *a, const void *b)
{
    double first = *(const double *)a, second = *(const double *)b;
    return (first > second) - (first < second);
}

static double quantile(const double sorted[], int count, double part)
{
    return 1e3 * sorted[(int)ceil(part * (count - 1))];
}

static void cancel(const long_call *call, void **scene, double most,
                   const latency_plan *plan)
{
    generator random = generator_new(1);
    double *latency = allocate((size_t)plan->moments, sizeof *latency);
    double longest = -1;
    const char *stage = "";
    for (int i = 0; i < plan->moments; i++) {
        stopwatch w = {.moment = uniform(&random, 0, most)};
        latency[i] = time_call(call, scene, plan, &w);
        if (latency[i] > longest) {
            longest = latency[i];
            stage = w.stage;
        }
    }
    qsort(latency, (size_t)plan->moments, sizeof *latency, compare);
    printf(" %8.2f %8.2f %8.2f  %s\n", quantile(latency, plan->moments, 0.5),
           quantile(latency, plan->moments, 0.9),
           quantile(latency, plan->moments, 1), stage);
    free(latency);
}

void latency_print(const long_call *call, const latency_plan *plan)
{
    void *scene = call->make(call->variant);
    stopwatch w = {.moment = plan->seconds};
    time_call(call, &scene, plan, &w);
    double whole = w.last - w.begin;
    printf("%-28s %7.2f %8ld %8.2f %-12s", call->name, whole, w.calls,
           1e3 * w.silence, w.silent_stage);
    fflush(stdout);
    cancel(call, &scene, whole, plan);
    fflush(stdout);
    call->release(scene);
}
