// How soon long calls on a surface of 100,000 triangles return once they are
// cancelled, in milliseconds of processor time:
//
//     cancelling COUNT
//
// cancels each of them at COUNT random moments.  Exit status 1: one took longer
// than a tenth of a second.
#include "bench/measuring.h"
#include "flow/flow.h"
#include "remesh/remesh.h"
#include "simulate/geodesic.h"
#include "support/adaptive_surfaces.h"
#include "support/generator.h"
#include "topology/reconnect.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum {
    DIVISION = 71 ///< of an icosahedron: 20 times its square are the triangles
};

static const double limit = 100;

static double now(void)
{
    return 1e3 * processor_seconds();
}

// The surface -----------------------------------------------------------------

/// A sphere with bumps of many sizes.
static tf_adaptive_surface *make_surface(void)
{
    tf_body body = {.axes = 3};
    tf_geodesic_add(&body, DIVISION);
    for (int v = 0; v < body.vertices; v++) {
        double *x = body.position + 3 * (ptrdiff_t)v;
        double far = 1 + 0.1 * sin(7 * x[0] + 2) * sin(6 * x[1]) +
                     0.01 * sin(50 * x[2]) + 0.001 * sin(300 * x[0]);
        for (int k = 0; k < 3; k++)
            x[k] *= far;
    }
    tf_mesh mesh = tf_body_mesh(&body);
    tf_adaptive_surface *surface = NULL;
    if (body.failed ||
        tf_adaptive_create(&mesh, body.position, &surface, NULL) != TF_OK)
        abort();
    tf_body_free(&body);
    return surface;
}

// Calls -----------------------------------------------------------------------

/// When a call was told, and when it cancels and has cancelled.
typedef struct moments {
    double last, longest; ///< time between two tells
    const char *stage, *longest_stage;
    double cancel, cancelled;
} moments;

static bool tell(void *context, const tf_stage *stage)
{
    moments *m = context;
    double time = now();
    if (time - m->last > m->longest) {
        m->longest = time - m->last;
        m->longest_stage = m->stage ? m->stage : stage->name;
    }
    m->stage = stage->name;
    m->last = time;
    m->cancelled = time;
    return time < m->cancel;
}

static tf_status remesh(tf_adaptive_surface *surface, double edge, moments *m)
{
    const tf_remesh_options how = {
        .edge = edge, .rounds = 1, .progress = tell, .context = m};
    return tf_adaptive_remesh(surface, &how, NULL, NULL);
}

static tf_status refine(tf_adaptive_surface *surface, moments *m)
{
    return remesh(surface, 0.012, m);
}

static tf_status coarsen(tf_adaptive_surface *surface, moments *m)
{
    return remesh(surface, 0.1, m);
}

static tf_status reconnect(tf_adaptive_surface *surface, moments *m)
{
    const tf_reconnect_options how = {
        .edge = 0.03, .drop = 1e6, .progress = tell, .context = m};
    return tf_adaptive_reconnect(surface, &how, NULL, NULL);
}

/// Against the normals, into contacts.
static void shrink(void *context, double time, int points, const double point[],
                   const double normal[], double velocity[])
{
    (void)context, (void)time, (void)point;
    for (int i = 0; i < 3 * points; i++)
        velocity[i] = -0.05 * normal[i];
}

static tf_status flow(tf_adaptive_surface *surface, moments *m)
{
    const tf_flow_options how = {
        .edge = 0.02, .velocity = shrink, .progress = tell, .context = m};
    tf_flow *made;
    tf_status status = tf_flow_create(surface, &made);
    m->last = now();
    if (status == TF_OK)
        status = tf_flow_step(made, 0, 1, &how, NULL, NULL);
    tf_flow_free(made);
    return status;
}

static const struct {
    const char *name;
    tf_status (*call)(tf_adaptive_surface *surface, moments *m);
} calls[] = {{"remesh more finely", refine},
             {"remesh more coarsely", coarsen},
             {"reconnect", reconnect},
             {"flow", flow}};

// Measuring -------------------------------------------------------------------

static void demand(bool good, const char *what)
{
    if (good)
        return;
    fprintf(stderr, "%s\n", what);
    exit(1);
}

/// How long a call takes in all, and how long it did not tell at most.
static double time_call(int call, moments *m)
{
    tf_adaptive_surface *surface = make_surface();
    double begin = now();
    *m = (moments){.last = begin, .cancel = INFINITY};
    demand(calls[call].call(surface, m) == TF_OK, "it failed");
    double took = now() - begin;
    tf_adaptive_free(surface);
    return took;
}

/// Cancels a call at random moments; returns the longest time to its return.
static double time_cancels(int call, double took, int count, double *mean)
{
    generator random = generator_new((uint64_t)call);
    tf_adaptive_surface *surface = make_surface();
    uint64_t before = adaptive_hash(surface);
    double longest = 0, sum = 0;
    int cancelled = 0;
    for (int i = 0; i < count; i++) {
        moments m = {.last = now()};
        m.cancel = m.last + uniform(&random, 0, took);
        tf_status status = calls[call].call(surface, &m);
        double late = now() - m.cancelled;
        if (status == TF_OK) { // it was faster this time
            tf_adaptive_free(surface);
            surface = make_surface();
            continue;
        }
        demand(status == TF_CANCELLED && adaptive_hash(surface) == before,
               "a cancelled call has changed the surface");
        longest = fmax(longest, late);
        sum += late;
        cancelled++;
    }
    *mean = sum / cancelled;
    tf_adaptive_free(surface);
    return longest;
}

int main(int argc, char *argv[])
{
    int count = argc > 1 ? atoi(argv[1]) : 20;
    double latest = 0;
    for (int i = 0; i < 4; i++) {
        moments m;
        double mean, took = time_call(i, &m);
        double longest = time_cancels(i, took, count, &mean);
        printf("%s: takes %.0f ms, tells every %.1f ms at least (%s); of %d "
               "cancels the latest returned after %.1f ms, the mean %.1f ms\n",
               calls[i].name, took, m.longest, m.longest_stage, count, longest,
               mean);
        fflush(stdout);
        latest = fmax(latest, longest);
    }
    demand(latest < limit, "a cancelled call took too long to return");
    return 0;
}
