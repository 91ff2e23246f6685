#include "kit/flow_run.h"

#include "base/require.h"
#include "flow/flow_state.h"

#include <stdlib.h>
#include <string.h>

// Running ----------------------------------------------------------------

static tf_adaptive_surface *begin(const tf_flow_scene *scene, double edge)
{
    tf_body body = {.axes = 3};
    scene->build(&body, edge);
    tf_mesh mesh = tf_body_mesh(&body);
    tf_adaptive_surface *surface = NULL;
    TF_REQUIRE(!body.failed && tf_adaptive_create(&mesh, body.position,
                                                  &surface, NULL) == TF_OK);
    tf_body_free(&body);
    return surface;
}

static void make_step(const fig_flow_plan *plan, const tf_flow_scene *scene,
                      tf_flow *flow, int step, fig_flow_run *run)
{
    const tf_flow_options options = {.edge = plan->edge,
                                     .velocity = scene->velocity,
                                     .keep_topology = scene->keep_topology ||
                                                      plan->keep_topology};
    tf_flow_report report;
    TF_REQUIRE(tf_flow_step(flow, &options, (step - 1) * scene->step,
                            scene->step, &report) == TF_OK);
    for (int i = 0; i < TF_RECONNECTIONS; i++)
        if (run->first[i] == 0 && report.reconnected.tried[i][TF_COMMITTED] > 0)
            run->first[i] = step;
}

/// After a step a surface has no gaps.
static void keep_frame(const tf_adaptive_surface *surface, fig_flow_run *run)
{
    fig_flow_frame *frame = &run->frame[run->frames++];
    tf_mesh mesh = tf_adaptive_mesh(surface);
    size_t size = 3 * sizeof *frame->x * (size_t)mesh.vertices;
    frame->x = malloc(size);
    TF_REQUIRE(frame->x && tf_flow_measure(surface, &frame->measures));
    TF_REQUIRE(tf_surface_create(&mesh, &frame->surface, NULL) == TF_OK);
    memcpy(frame->x, tf_adaptive_positions(surface), size);
}

fig_flow_run *fig_flow_run_new(const fig_flow_plan *plan)
{
    const tf_flow_scene *scene = tf_flow_scene_named(plan->scene);
    fig_flow_run *run = calloc(1, sizeof *run);
    TF_REQUIRE(scene && run);
    int frames = plan->steps / plan->every + 1;
    run->frame = calloc((size_t)frames, sizeof *run->frame);
    TF_REQUIRE(run->frame);
    tf_adaptive_surface *surface = begin(scene, plan->edge);
    tf_flow *flow = NULL;
    TF_REQUIRE(tf_flow_create(surface, &flow) == TF_OK);
    if (plan->policy)
        flow->remesher.policy = plan->policy;
    keep_frame(surface, run);
    for (int step = 1; step <= plan->steps; step++) {
        make_step(plan, scene, flow, step, run);
        if (step % plan->every == 0)
            keep_frame(surface, run);
    }
    tf_flow_free(flow);
    tf_adaptive_free(surface);
    return run;
}

// Looking at what was run ------------------------------------------------

static fig_cloth *cloth_of(const fig_flow_frame *frame)
{
    fig_cloth *cloth = fig_cloth_new(frame->surface, 3);
    TF_REQUIRE(cloth);
    TF_REQUIRE(fig_cloth_add(cloth, frame->measures.vertices, frame->x));
    return cloth;
}

fig_cloth **fig_flow_run_films(int runs, fig_flow_run *const run[])
{
    int count = 0, all = 0;
    for (int r = 0; r < runs; r++)
        all += run[r]->frames;
    TF_REQUIRE(all > 0);
    fig_cloth **cloth = calloc((size_t)all, sizeof(fig_cloth *));
    TF_REQUIRE(cloth);
    for (int r = 0; r < runs; r++)
        for (int i = 0; i < run[r]->frames; i++)
            cloth[count++] = cloth_of(&run[r]->frame[i]);
    TF_REQUIRE(fig_cloth_end_all(all, cloth));
    return cloth;
}
