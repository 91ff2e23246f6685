//: Include what threads need
#define _POSIX_C_SOURCE 200809L
#include "program/threads.h"

#include <pthread.h>
#include <stdatomic.h>
#include <unistd.h>

//: Take one task after another
typedef struct crew {
    int count; ///< of tasks
    tf_task *run;
    void *argument;
    atomic_int next;
} crew;

typedef struct member {
    crew *crew;
    int worker;
    pthread_t thread;
} member;

static void *take_tasks(void *argument)
{
    const member *own = argument;
    crew *all = own->crew;
    for (;;) {
        int task = atomic_fetch_add(&all->next, 1);
        if (task >= all->count)
            return NULL;
        all->run(all->argument, task, own->worker);
    }
}

//: Run tasks on several threads
static void for_each(void *context, int count, tf_task *run, void *argument)
{
    const int *threads = context;
    crew all = {.count = count, .run = run, .argument = argument};
    member members[TF_MOST_THREADS] = {{.crew = &all}};
    int started = 1;
    // If no more threads can be started, those that were do all the work.
    for (; started < *threads && started < count; started++) {
        member *own = &members[started];
        own->crew = &all;
        own->worker = started;
        if (pthread_create(&own->thread, NULL, take_tasks, own) != 0)
            break;
    }
    take_tasks(&members[0]);
    for (int i = 1; i < started; i++)
        pthread_join(members[i].thread, NULL);
}

tf_parallel tf_threads(const int *count)
{
    return (tf_parallel){*count, for_each, (void *)count};
}

//: Count the processors
int tf_threads_available(void)
{
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    return processors < 1                 ? 1
           : processors > TF_MOST_THREADS ? TF_MOST_THREADS
                                          : (int)processors;
}
