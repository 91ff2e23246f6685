//: Include what simulations need
#include "simulate/simulation.h"

#include <stdlib.h>

//: Set a scene up
tf_status tf_simulation_create(const tf_scene *scene, double resolution,
                               tf_simulation **simulation)
{
    tf_simulation *s = calloc(1, scene->kind->size);
    if (!s)
        return TF_OUT_OF_MEMORY;
    s->scene = scene;
    s->resolution = resolution;
    s->setup.scene = scene;
    s->setup.body.axes = scene->plane ? 2 : 3;
    scene->build(&s->setup, resolution);
    tf_status status =
        s->setup.body.failed ? TF_OUT_OF_MEMORY : scene->kind->begin(s);
    if (status == TF_OK)
        *simulation = s;
    else
        tf_simulation_free(s);
    return status;
}

void tf_simulation_go_to(tf_simulation *simulation, int step)
{
    simulation->step = step;
    simulation->time = step * simulation->scene->step;
}

void tf_simulation_free(tf_simulation *simulation)
{
    if (!simulation)
        return;
    simulation->scene->kind->end(simulation);
    tf_body_free(&simulation->setup.body);
    free(simulation);
}
