//: Include what simulations of cloth need
#include "simulate/cloth_simulation.h"

#include "simulate/air.h"

#include <stdlib.h>
#include <string.h>

enum {
    ITERATIONS = 10 // of the dynamics in a step
};

//: Begin a simulation of cloth
static size_t bytes_of(const tf_body *body)
{
    return sizeof(double) * (size_t)(body->axes * body->vertices);
}

static bool allocate(tf_cloth_simulation *c)
{
    const tf_body *body = &c->base.setup.body;
    size_t vertices = (size_t)body->vertices, size = bytes_of(body);
    c->position = malloc(size);
    c->velocity = calloc(1, size);
    c->end = malloc(size);
    c->inverse_mass = malloc(sizeof(double) * vertices);
    if (!c->position || !c->velocity || !c->end || !c->inverse_mass)
        return false;
    memcpy(c->position, body->position, size);
    for (size_t v = 0; v < vertices; v++)
        c->inverse_mass[v] = body->mass[v] > 0 ? 1 / body->mass[v] : 0;
    return true;
}

static tf_status begin_cloth(tf_simulation *simulation)
{
    tf_cloth_simulation *c = (tf_cloth_simulation *)simulation;
    const tf_body *body = &simulation->setup.body;
    tf_mesh mesh = tf_body_mesh(body);
    if (!allocate(c))
        return TF_OUT_OF_MEMORY;
    tf_status status = tf_surface_create(&mesh, &c->surface, NULL);
    if (status == TF_OK && simulation->setup.filter.wanted)
        status =
            tf_surface_set_filter(c->surface, &simulation->setup.filter, NULL);
    if (status == TF_OK)
        status = tf_resolver_create(c->surface, &c->resolver);
    if (status == TF_OK)
        status = tf_coupling_create(body, simulation->scene->step, c->resolver,
                                    &c->coupling);
    if (status == TF_OK)
        status =
            tf_dynamics_create(body, simulation->scene->step, &c->dynamics);
    return status;
}

static void end_cloth(tf_simulation *simulation)
{
    tf_cloth_simulation *c = (tf_cloth_simulation *)simulation;
    tf_dynamics_free(c->dynamics);
    tf_coupling_free(c->coupling);
    tf_resolver_free(c->resolver);
    tf_surface_free(c->surface);
    free(c->position);
    free(c->velocity);
    free(c->end);
    free(c->inverse_mass);
}

//: Propose where a step ends
static void fall(tf_cloth_simulation *c)
{
    const tf_scene *scene = c->base.scene;
    const tf_body *body = &c->base.setup.body;
    int up = tf_body_up(body);
    for (int v = 0; v < body->vertices; v++)
        if (body->mass[v] > 0)
            c->velocity[body->axes * v + up] -= scene->gravity * scene->step;
}

/// Where inertia leads, the scripts, and the path.
static bool fly(tf_cloth_simulation *c)
{
    const tf_scene_setup *setup = &c->base.setup;
    const tf_body *body = &setup->body;
    double step = c->base.scene->step;
    for (int i = 0; i < body->axes * body->vertices; i++)
        c->end[i] =
            c->position[i] +
            (body->mass[i / body->axes] > 0 ? step * c->velocity[i] : 0);
    for (int i = 0; i < setup->scripts; i++)
        tf_script_place(&setup->script[i], body, (c->script_steps + 1) * step,
                        c->end);
    return !setup->path.place ||
           setup->path.place(setup->path.context, (c->script_steps + 1) * step,
                             c->end);
}

tf_status tf_cloth_propose(tf_cloth_simulation *cloth)
{
    const tf_scene *scene = cloth->base.scene;
    fall(cloth);
    tf_air_blow(&scene->air, &cloth->base.setup.body, cloth->base.time,
                scene->step, cloth->position, cloth->velocity);
    if (!fly(cloth))
        return TF_CANCELLED;
    return tf_dynamics_step(cloth->dynamics, cloth->end, ITERATIONS);
}

//: Go on from where a step ends
void tf_cloth_accept(tf_cloth_simulation *cloth, const double unpushed[],
                     int held)
{
    const tf_body *body = &cloth->base.setup.body;
    for (int i = 0; i < body->axes * body->vertices; i++) {
        cloth->velocity[i] =
            (unpushed[i] - cloth->position[i]) / cloth->base.scene->step;
        cloth->position[i] = cloth->end[i];
    }
    tf_simulation_go_to(&cloth->base, cloth->base.step + 1);
    cloth->script_steps += held == 0;
}

//: Make a step of cloth
tf_coupling_energy tf_cloth_energy(const tf_cloth_simulation *cloth)
{
    const tf_body *body = &cloth->base.setup.body;
    double gravity = cloth->base.scene->gravity;
    return (tf_coupling_energy){
        gravity, tf_body_kinetic_energy(body, cloth->velocity) +
                     tf_body_potential_energy(body, gravity, cloth->position)};
}

static bool is_blown(const tf_air *air)
{
    return air->wind[0] != 0 || air->wind[1] != 0 || air->wind[2] != 0 ||
           air->gust != 0;
}

tf_status tf_cloth_resolve(tf_cloth_simulation *cloth,
                           const tf_coupling_energy *energy,
                           const tf_response_options *options,
                           tf_response_report *report)
{
    bool blown = is_blown(&cloth->base.scene->air);
    return tf_coupling_resolve(cloth->coupling, cloth->position, cloth->end,
                               cloth->inverse_mass, options,
                               blown ? NULL : energy, report);
}

static double now(const tf_step_options *options)
{
    return options->clock ? options->clock() : 0;
}

static void measure(const tf_cloth_simulation *c, tf_cloth_report *report)
{
    const tf_body *body = &c->base.setup.body;
    report->stretch = tf_body_stretch(body, c->position);
    report->kinetic = tf_body_kinetic_energy(body, c->velocity);
    report->elastic = tf_body_elastic_energy(body, c->position);
}

static tf_status step_cloth(tf_simulation *simulation,
                            const tf_step_options *options)
{
    tf_cloth_simulation *c = (tf_cloth_simulation *)simulation;
    tf_cloth_report report = {0};
    double begin = now(options);
    tf_response_options response = {.friction = c->base.scene->friction,
                                    .vertex_friction =
                                        simulation->setup.friction,
                                    .check_start = options->check,
                                    .parallel = options->parallel};
    tf_coupling_energy energy = tf_cloth_energy(c);
    tf_status status = tf_cloth_propose(c);
    double proposed = now(options);
    if (status == TF_OK)
        status = tf_cloth_resolve(c, &energy, &response, &report.response);
    if (status != TF_OK)
        return status;
    report.dynamics_seconds = proposed - begin;
    report.response_seconds = now(options) - proposed;
    tf_cloth_accept(c, tf_resolver_unpushed(c->resolver), report.response.held);
    measure(c, &report);
    c->report = report;
    return TF_OK;
}

//: Take and restore a snapshot of cloth
static tf_snapshot take_cloth(const tf_simulation *simulation)
{
    const tf_cloth_simulation *c = (const tf_cloth_simulation *)simulation;
    return (tf_snapshot){.step = simulation->step,
                         .script_steps = c->script_steps,
                         .mesh = tf_body_mesh(&simulation->setup.body),
                         .position = c->position,
                         .velocity = c->velocity};
}

static tf_status restore_cloth(tf_simulation *simulation,
                               const tf_snapshot *snapshot)
{
    tf_cloth_simulation *c = (tf_cloth_simulation *)simulation;
    const tf_body *body = &simulation->setup.body;
    if (snapshot->mesh.vertices != body->vertices)
        return TF_BAD_COUNT;
    memcpy(c->position, snapshot->position, bytes_of(body));
    memcpy(c->velocity, snapshot->velocity, bytes_of(body));
    tf_simulation_go_to(simulation, snapshot->step);
    c->script_steps = snapshot->script_steps;
    return TF_OK;
}

//: Describe simulations of cloth
const tf_simulation_kind tf_cloth_kind = {
    .option = "size",
    .size = sizeof(tf_cloth_simulation),
    .begin = begin_cloth,
    .end = end_cloth,
    .step = step_cloth,
    .snapshot = take_cloth,
    .restore = restore_cloth,
};
