//: Include what simulations of flows need
#include "simulate/flow_simulation.h"

#include <stdlib.h>

//: Set a scene of a flow up
static tf_status build_surface(const tf_flow_scene *scene, double edge,
                               tf_adaptive_surface **surface)
{
    tf_body body = {.axes = 3};
    scene->build(&body, edge);
    tf_mesh mesh = tf_body_mesh(&body);
    tf_status status =
        body.failed ? TF_OUT_OF_MEMORY
                    : tf_adaptive_create(&mesh, body.position, surface, NULL);
    tf_body_free(&body);
    return status;
}

//: Create a simulation of a flow
tf_status tf_flow_simulation_create(const tf_flow_scene *scene, double edge,
                                    tf_flow_simulation **simulation)
{
    tf_flow_simulation *s = calloc(1, sizeof *s);
    if (!s)
        return TF_OUT_OF_MEMORY;
    s->scene = scene;
    s->edge = edge;
    tf_status status = build_surface(scene, edge, &s->surface);
    if (status == TF_OK)
        status = tf_flow_create(s->surface, &s->flow);
    if (status == TF_OK)
        *simulation = s;
    else
        tf_flow_simulation_free(s);
    return status;
}

void tf_flow_simulation_free(tf_flow_simulation *simulation)
{
    if (!simulation)
        return;
    tf_flow_free(simulation->flow);
    tf_adaptive_free(simulation->surface);
    free(simulation);
}

//: Make a step of a flow's simulation
tf_status tf_flow_simulation_step(tf_flow_simulation *simulation,
                                  const tf_step_way *way,
                                  tf_flow_report *report)
{
    const tf_flow_scene *scene = simulation->scene;
    tf_flow_options options = {.edge = simulation->edge,
                               .velocity = scene->velocity,
                               .keep_topology = scene->keep_topology,
                               .parallel = way->parallel,
                               .clock = way->clock};
    tf_flow_report made;
    tf_status status =
        tf_flow_step(simulation->flow, &options, simulation->step * scene->step,
                     scene->step, &made);
    if (status != TF_OK)
        return status;
    simulation->step++;
    *report = made;
    return TF_OK;
}

//: Go on from another surface
tf_status tf_flow_simulation_restore(tf_flow_simulation *simulation, int step,
                                     const tf_mesh *mesh,
                                     const double position[])
{
    tf_adaptive_surface *surface;
    tf_flow *flow;
    tf_status status = tf_adaptive_create(mesh, position, &surface, NULL);
    if (status != TF_OK)
        return status;
    status = tf_flow_create(surface, &flow);
    if (status != TF_OK) {
        tf_adaptive_free(surface);
        return status;
    }
    tf_flow_free(simulation->flow);
    tf_adaptive_free(simulation->surface);
    simulation->flow = flow;
    simulation->surface = surface;
    simulation->step = step;
    return TF_OK;
}
