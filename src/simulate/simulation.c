//: Include what simulations need
#include "simulate/simulation.h"

#include "simulate/air.h"

#include <stdlib.h>
#include <string.h>

enum {
    ITERATIONS = 10 // of the dynamics in a step
};

//: Set a scene up
static bool allocate(tf_simulation *s)
{
    const tf_body *body = &s->stage.body;
    size_t vertices = (size_t)body->vertices;
    size_t size = sizeof(double) * vertices * (size_t)body->axes;
    s->position = malloc(size);
    s->velocity = calloc(1, size);
    s->end = malloc(size);
    s->inverse_mass = malloc(sizeof(double) * vertices);
    if (!s->position || !s->velocity || !s->end || !s->inverse_mass)
        return false;
    memcpy(s->position, body->position, size);
    for (size_t v = 0; v < vertices; v++)
        s->inverse_mass[v] = body->mass[v] > 0 ? 1 / body->mass[v] : 0;
    return true;
}

static tf_status set_up(tf_simulation *s)
{
    tf_scene_build(s->scene, s->size, &s->stage);
    if (s->stage.body.failed || !allocate(s))
        return TF_OUT_OF_MEMORY;
    tf_mesh mesh = tf_body_mesh(&s->stage.body);
    tf_status status = tf_surface_create(&mesh, &s->surface, NULL);
    if (status == TF_OK)
        status = tf_resolver_create(s->surface, &s->resolver);
    if (status == TF_OK)
        status =
            tf_dynamics_create(&s->stage.body, s->scene->step, &s->dynamics);
    return status;
}

tf_status tf_simulation_create(const tf_scene *scene, int size,
                               tf_simulation **simulation)
{
    tf_simulation *s = calloc(1, sizeof *s);
    if (!s)
        return TF_OUT_OF_MEMORY;
    s->scene = scene;
    s->size = size;
    tf_status status = set_up(s);
    if (status == TF_OK)
        *simulation = s;
    else
        tf_simulation_free(s);
    return status;
}

void tf_simulation_free(tf_simulation *simulation)
{
    if (!simulation)
        return;
    tf_dynamics_free(simulation->dynamics);
    tf_resolver_free(simulation->resolver);
    tf_surface_free(simulation->surface);
    tf_body_free(&simulation->stage.body);
    free(simulation->position);
    free(simulation->velocity);
    free(simulation->end);
    free(simulation->inverse_mass);
    free(simulation);
}

//: Propose where a step ends
static void fall(tf_simulation *s)
{
    const tf_body *body = &s->stage.body;
    int up = body->axes - 1;
    for (int v = 0; v < body->vertices; v++)
        if (body->mass[v] > 0)
            s->velocity[body->axes * v + up] -=
                s->scene->gravity * s->scene->step;
}

/// Where inertia leads, and the script.
static void fly(tf_simulation *s)
{
    const tf_body *body = &s->stage.body;
    for (int i = 0; i < body->axes * body->vertices; i++)
        s->end[i] = s->position[i] + (body->mass[i / body->axes] > 0
                                          ? s->scene->step * s->velocity[i]
                                          : 0);
    for (int i = 0; i < s->stage.handles; i++)
        tf_handle_place(&s->stage.handle[i], body,
                        (s->scripted + 1) * s->scene->step, s->end);
}

tf_status tf_simulation_propose(tf_simulation *simulation)
{
    const tf_scene *scene = simulation->scene;
    fall(simulation);
    tf_air_blow(&scene->air, &simulation->stage.body,
                simulation->step * scene->step, scene->step,
                simulation->position, simulation->velocity);
    fly(simulation);
    return tf_dynamics_step(simulation->dynamics, simulation->end, ITERATIONS);
}

//: Go on from where a step ends
void tf_simulation_accept(tf_simulation *simulation, int held)
{
    const tf_body *body = &simulation->stage.body;
    for (int i = 0; i < body->axes * body->vertices; i++) {
        simulation->velocity[i] =
            (simulation->end[i] - simulation->position[i]) /
            simulation->scene->step;
        simulation->position[i] = simulation->end[i];
    }
    simulation->step++;
    simulation->scripted += held == 0;
}

//: Make a step of a simulation
static tf_status resolve(tf_simulation *s, const tf_step_way *way,
                         tf_response_report *report)
{
    tf_response_options options = {.friction = s->scene->friction,
                                   .check_start = way->check,
                                   .parallel = way->parallel};
    return tf_step_resolve(s->resolver, s->stage.body.vertices, s->position,
                           s->end, s->inverse_mass, &options, report, NULL);
}

static double now(const tf_step_way *way)
{
    return way->clock ? way->clock() : 0;
}

tf_status tf_simulation_step(tf_simulation *simulation, const tf_step_way *way,
                             tf_step_cost *cost)
{
    tf_step_cost made = {0};
    double begin = now(way);
    tf_status status = tf_simulation_propose(simulation);
    double proposed = now(way);
    if (status == TF_OK)
        status = resolve(simulation, way, &made.report);
    if (status != TF_OK)
        return status;
    made.dynamics = proposed - begin;
    made.response = now(way) - proposed;
    tf_simulation_accept(simulation, made.report.held);
    *cost = made;
    return TF_OK;
}
