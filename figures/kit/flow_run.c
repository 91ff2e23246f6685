#include "kit/flow_run.h"

#include "base/require.h"
#include "flow/flow_state.h"
#include "simulate/flow_scenes.h"

#include <stdlib.h>
#include <string.h>

// Running ----------------------------------------------------------------

static void make_step(const fig_flow_plan *plan, tf_flow_simulation *flow,
                      fig_flow_run *run)
{
    const tf_scene *scene = flow->base.scene;
    tf_flow_options options = tf_flow_options_of(scene, plan->edge);
    options.keep_topology |= plan->keep_topology;
    const tf_flow_report *report;
    TF_REQUIRE(tf_flow_step(flow->flow, flow->base.time, scene->step, &options,
                            &report, NULL) == TF_OK);
    tf_simulation_go_to(&flow->base, flow->base.step + 1);
    for (int i = 0; i < TF_RECONNECTIONS; i++)
        if (run->first[i] == 0 &&
            report->reconnected->tried[i][TF_COMMITTED] > 0)
            run->first[i] = flow->base.step;
}

/// After a step a surface has no gaps.
static void keep_frame(const tf_adaptive_surface *surface, fig_flow_run *run)
{
    fig_flow_frame *frame = &run->frame[run->frames++];
    tf_mesh mesh = *tf_adaptive_mesh(surface);
    size_t size = 3 * sizeof *frame->x * (size_t)mesh.vertices;
    frame->x = malloc(size);
    TF_REQUIRE(frame->x && tf_flow_measure(surface, &frame->measures));
    TF_REQUIRE(tf_surface_create(&mesh, &frame->surface, NULL) == TF_OK);
    memcpy(frame->x, tf_adaptive_positions(surface), size);
}

fig_flow_run *fig_flow_run_new(const fig_flow_plan *plan)
{
    const tf_scene *scene = tf_scene_named(tf_flow_scenes, plan->scene);
    fig_flow_run *run = calloc(1, sizeof *run);
    tf_simulation *s;
    TF_REQUIRE(scene && run &&
               tf_simulation_create(scene, plan->edge, &s) == TF_OK);
    tf_flow_simulation *flow = (tf_flow_simulation *)s;
    if (plan->policy)
        flow->flow->remesher.policy = plan->policy;
    int frames = plan->steps / plan->every + 1;
    run->frame = calloc((size_t)frames, sizeof *run->frame);
    TF_REQUIRE(run->frame);
    keep_frame(flow->surface, run);
    while (s->step < plan->steps) {
        make_step(plan, flow, run);
        if (s->step % plan->every == 0)
            keep_frame(flow->surface, run);
    }
    tf_simulation_free(s);
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
