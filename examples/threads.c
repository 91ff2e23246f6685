// A surface divided among threads of one's own: this thread and another.  A
// program with a job system gives the tasks to that; one without can take the
// pool of tanglefree_threads.h, which keeps its threads from call to call.
//
//     cc threads.c -pthread $(pkg-config --cflags --libs tanglefree) -o threads
#include <pthread.h>
#include <stdio.h>
#include <tanglefree.h>

typedef struct work {
    tf_task *run;
    void *argument;
    int count, worker; // no two threads may have the same number
} work;

static void *run_every_other(void *mine)
{
    const work *own = (const work *)mine;
    for (int task = own->worker; task < own->count; task += 2)
        own->run(own->argument, task, own->worker);
    return NULL;
}

static void for_each(void *context, int count, tf_task *run, void *argument)
{
    work even = {run, argument, count, 0}, odd = {run, argument, count, 1};
    pthread_t other;
    (void)context; // that of `two` below, where a job system would be
    bool started = pthread_create(&other, NULL, run_every_other, &odd) == 0;
    run_every_other(&even);
    if (started)
        pthread_join(other, NULL);
    else
        run_every_other(&odd);
}

int main(void)
{
    static double start[900], end[900]; // of 300 vertices
    static int triangles[300];
    for (int i = 0; i < 900; i++) {
        start[i] = i * i % 101; // anywhere, but the same on every machine
        end[i] = start[i] + i * 7 % 13;
        triangles[i / 3] = i / 3;
    }
    const tf_mesh mesh = {3, 300, 100, triangles, 0, NULL};
    const tf_motion motion = {3, 300, start, end};
    const tf_parallel two = {2, for_each, NULL};
    static tf_detect_options options; // all zero: the usual choices
    options.parallel = &two;

    tf_surface *surface = NULL;
    tf_contacts found;
    if (tf_surface_create(&mesh, &surface, NULL) == TF_OK &&
        tf_surface_detect(surface, &motion, &options, &found, NULL) == TF_OK)
        printf("%d contacts\n", (int)found.count); // by any number of threads
    tf_surface_free(surface);
    return 0;
}
