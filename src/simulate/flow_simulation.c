//: Include what simulations of flows need
#include "simulate/flow_simulation.h"

#include "simulate/flow_fields.h"

//: Set the surface of a flow
static void free_surface(tf_flow_simulation *f)
{
    tf_flow_free(f->flow);
    tf_adaptive_free(f->surface);
}

/// Unless this is TF_OK, the surface is the one that it was.
static tf_status set_surface(tf_flow_simulation *f, const tf_mesh *mesh,
                             const double position[])
{
    tf_adaptive_surface *surface;
    tf_flow *flow = NULL;
    tf_status status = tf_adaptive_create(mesh, position, &surface, NULL);
    if (status != TF_OK)
        return status;
    if (tf_flow_create(surface, &flow) != TF_OK ||
        !tf_flow_measure(surface, &f->measures)) {
        tf_flow_free(flow);
        tf_adaptive_free(surface);
        return TF_OUT_OF_MEMORY;
    }
    free_surface(f);
    f->flow = flow;
    f->surface = surface;
    return TF_OK;
}

//: Begin and end a simulation of a flow
static tf_status begin_flow(tf_simulation *simulation)
{
    tf_body *body = &simulation->setup.body;
    tf_mesh mesh = tf_body_mesh(body);
    tf_status status =
        set_surface((tf_flow_simulation *)simulation, &mesh, body->position);
    tf_body_free(body);
    return status;
}

static void end_flow(tf_simulation *simulation)
{
    free_surface((tf_flow_simulation *)simulation);
}

//: Describe how a scene flows
tf_flow_options tf_flow_options_of(const tf_scene *scene, double edge)
{
    return (tf_flow_options){.edge = edge,
                             .velocity = tf_field_apply,
                             .context = (void *)&scene->field,
                             .keep_topology = scene->keep_topology};
}

//: Hold the context of a step
/// The context of a step: the field, as that of tf_field_apply, and the clock.
typedef struct step_context {
    tf_velocity_field *field;
    double (*clock)(void);
} step_context;

static double read_clock(void *context)
{
    const step_context *step = context;
    return step->clock ? step->clock() : 0;
}

/// With what it points to, which is only lent.
static void keep_report(tf_flow_simulation *f, const tf_flow_report *report)
{
    f->report = *report;
    f->reconnected = *report->reconnected;
    f->response = *report->response;
}

//: Make a step of a flow's simulation
static tf_status step_flow(tf_simulation *simulation,
                           const tf_step_options *options)
{
    tf_flow_simulation *f = (tf_flow_simulation *)simulation;
    const tf_scene *scene = simulation->scene;
    step_context context = {scene->field, options->clock};
    tf_flow_options flow = tf_flow_options_of(scene, simulation->resolution);
    flow.parallel = options->parallel;
    flow.clock = read_clock;
    flow.context = &context;
    const tf_flow_report *report;
    tf_status status = tf_flow_step(f->flow, simulation->time, scene->step,
                                    &flow, &report, NULL);
    if (status == TF_OK)
        keep_report(f, report);
    if (status == TF_OK && !tf_flow_measure(f->surface, &f->measures))
        status = TF_OUT_OF_MEMORY;
    if (status == TF_OK)
        tf_simulation_go_to(simulation, simulation->step + 1);
    return status;
}

//: Take and restore a snapshot of a flow
static tf_snapshot take_flow(const tf_simulation *simulation)
{
    const tf_flow_simulation *f = (const tf_flow_simulation *)simulation;
    return (tf_snapshot){.step = simulation->step,
                         .mesh = *tf_adaptive_mesh(f->surface),
                         .position = tf_adaptive_positions(f->surface)};
}

static tf_status restore_flow(tf_simulation *simulation,
                              const tf_snapshot *snapshot)
{
    tf_status status = set_surface((tf_flow_simulation *)simulation,
                                   &snapshot->mesh, snapshot->position);
    if (status == TF_OK)
        tf_simulation_go_to(simulation, snapshot->step);
    return status;
}

//: Describe simulations of flows
const tf_simulation_kind tf_flow_kind = {
    .option = "edge",
    .size = sizeof(tf_flow_simulation),
    .begin = begin_flow,
    .end = end_flow,
    .step = step_flow,
    .snapshot = take_flow,
    .restore = restore_flow,
};
