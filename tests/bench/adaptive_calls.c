#include "bench/long_calls.h"

#include "bench/measuring.h"
#include "flow/flow.h"
#include "remesh/remesh.h"
#include "simulate/geodesic.h"
#include "topology/reconnect.h"

#include <math.h>
#include <stdlib.h>

enum {
    DIVISION = 71 // of an icosahedron's edges; 100,820 triangles
};

/// A sphere with bumps of many sizes.
static void *make(int variant)
{
    tf_body body = {.axes = 3};
    (void)variant;
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
    if (body.failed)
        abort();
    require(tf_adaptive_create(&mesh, body.position, &surface, NULL));
    tf_body_free(&body);
    return surface;
}

static void release(void *made)
{
    tf_adaptive_free(made);
}

// Calls -----------------------------------------------------------------------

typedef enum target {
    FINER,
    COARSER,
} target;

static tf_status remesh(void *surface, int variant, const watched *how)
{
    const tf_remesh_options options = {.edge = variant == FINER ? 0.012 : 0.1,
                                       .rounds = 1,
                                       .progress = how->progress,
                                       .context = how->context};
    return tf_adaptive_remesh(surface, &options, NULL, NULL);
}

static tf_status reconnect(void *surface, int variant, const watched *how)
{
    const tf_reconnect_options options = {.edge = 0.03,
                                          .drop = 1e6,
                                          .progress = how->progress,
                                          .context = how->context};
    (void)variant;
    return tf_adaptive_reconnect(surface, &options, NULL, NULL);
}

/// Against the normals, into contacts.
static void shrink(void *context, double time, int points, const double point[],
                   const double normal[], double velocity[])
{
    (void)context, (void)time, (void)point;
    for (int i = 0; i < 3 * points; i++)
        velocity[i] = -0.05 * normal[i];
}

static tf_status flow(void *surface, int variant, const watched *how)
{
    const tf_flow_options options = {.edge = 0.02,
                                     .velocity = shrink,
                                     .parallel = how->parallel,
                                     .progress = how->progress,
                                     .context = how->context};
    tf_flow *made;
    (void)variant;
    require(tf_flow_create(surface, &made));
    tf_status status = tf_flow_step(made, 0, 1, &options, NULL, NULL);
    tf_flow_free(made);
    return status;
}

const long_call adaptive_calls[] = {
    {"remesh, finer", FINER, make, release, remesh},
    {"remesh, coarser", COARSER, make, release, remesh},
    {"reconnect", 0, make, release, reconnect},
    {"flow", 0, make, release, flow},
    {0},
};
