// A surface divided among threads of one's own, as simple as can be.  A program
// with a job system hands the tasks to that; one without takes the pool of
// tanglefree_threads.h, which keeps its threads from one call to the next.
//
//     cc threads.c -pthread $(pkg-config --cflags --libs tanglefree) -o threads
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tanglefree.h>

enum {
    WORKERS = 4,
    VERTICES = 300 // each three of them are a triangle
};

// A worker takes each fourth task.  No two workers may have the same number.
typedef struct work {
    tf_task *run;
    void *argument;
    int worker, count;
} work;

static void *run_tasks(void *mine)
{
    const work *own = (const work *)mine;
    for (int task = own->worker; task < own->count; task += WORKERS)
        own->run(own->argument, task, own->worker);
    return NULL;
}

static void for_each(void *context, int count, tf_task *run, void *argument)
{
    pthread_t thread[WORKERS];
    work all[WORKERS];
    (void)context; // the job system, if there is one
    for (int i = 0; i < WORKERS; i++) {
        all[i].run = run;
        all[i].argument = argument;
        all[i].worker = i;
        all[i].count = count;
        if (pthread_create(&thread[i], NULL, run_tasks, &all[i]) != 0)
            abort();
    }
    for (int i = 0; i < WORKERS; i++)
        pthread_join(thread[i], NULL);
}

int main(void)
{
    static double start[3 * VERTICES], end[3 * VERTICES];
    static int triangles[VERTICES];
    for (int i = 0; i < 3 * VERTICES; i++) {
        start[i] = i * i % 101; // anywhere, but the same on every machine
        end[i] = start[i] + i * 7 % 13;
        triangles[i / 3] = i / 3;
    }
    const tf_mesh mesh = {3, VERTICES, VERTICES / 3, triangles, 0, NULL};
    const tf_motion motion = {3, VERTICES, start, end};
    const tf_parallel parallel = {WORKERS, for_each, NULL};

    tf_detect_options options;
    memset(&options, 0, sizeof options); // zero is the usual choice
    options.parallel = &parallel;
    tf_surface *surface = NULL;
    tf_contacts found;
    tf_status status = tf_surface_create(&mesh, &surface, NULL);
    if (status == TF_OK)
        status = tf_surface_detect(surface, &motion, &options, &found, NULL);
    if (status == TF_OK) // the same bits by any number of threads
        printf("%d contacts, found by %d threads\n", (int)found.count, WORKERS);
    else
        puts(tf_status_message(status));
    tf_surface_free(surface);
    return status != TF_OK;
}
