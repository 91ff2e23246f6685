//: Include what a flow needs
#include "flow/flow_state.h"

#include "base/environment.h"
#include "base/require.h"

#include <math.h>
#include <string.h>

enum {
    IMPROVING_PASSES = 3 ///< at most, of splits and of flips
};

//: Recognize what keeps the volume
bool tf_flow_keeps_volume(const tf_flow_state *flow, tf_operation operation)
{
    return (flow->options->careless >> operation & 1) == 0;
}

//: Repeat a pass
/// Until it does nothing, or for the last time.
static tf_status repeat_pass(tf_flow_state *flow, tf_operation operation,
                             tf_status pass(tf_flow_state *flow))
{
    const size_t *done = &flow->remesher.report->tried[operation][TF_COMMITTED];
    tf_status status = TF_OK;
    size_t before = *done - 1;
    for (int i = 0; i < IMPROVING_PASSES && status == TF_OK && *done != before;
         i++) {
        before = *done;
        status = pass(flow);
    }
    return status;
}

//: Improve a surface that flows
static tf_status improve(tf_flow_state *flow)
{
    tf_status status = repeat_pass(flow, TF_SPLIT, tf_refine_pass);
    if (status == TF_OK)
        status = repeat_pass(flow, TF_FLIP, tf_turn_pass);
    if (status == TF_OK)
        status = tf_coarsen_pass(flow);
    return status == TF_OK ? tf_relax_pass(flow) : status;
}

//: Go through the parts of a step
static double clock_of(const tf_flow_state *flow)
{
    return flow->options->clock ? flow->options->clock() : 0;
}

static tf_status reconnect(tf_flow_state *flow)
{
    tf_reconnect_options options = {.edge = flow->options->edge};
    return flow->options->keep_topology
               ? TF_OK
               : tf_adaptive_reconnect(flow->remesher.surface, &options,
                                       &flow->report->reconnected);
}

static tf_status flow(tf_flow_state *flow, double time, double step)
{
    double begin[TF_FLOW_PARTS + 1] = {clock_of(flow)};
    tf_status status = improve(flow);
    begin[TF_RECONNECT] = clock_of(flow);
    if (status == TF_OK)
        status = reconnect(flow);
    begin[TF_ADVANCE] = clock_of(flow);
    if (status == TF_OK)
        status = tf_advect(flow, time, step);
    begin[TF_FLOW_PARTS] = clock_of(flow);
    for (int i = 0; i < TF_FLOW_PARTS; i++)
        flow->report->seconds[i] = begin[i + 1] - begin[i];
    return status;
}

//: Make a step of a flow
tf_status tf_adaptive_flow(tf_adaptive_surface *surface,
                           const tf_flow_options *options, double time,
                           double step, tf_flow_report *report)
{
    TF_REQUIRE(surface && options && options->velocity);
    if (!tf_environment_is_ieee())
        return TF_BAD_ENVIRONMENT;
    if (!(options->edge > 0) || !isfinite(options->edge))
        return TF_BAD_TOLERANCE;
    tf_flow_report unused = {0}, *made = report ? report : &unused;
    *made = (tf_flow_report){0};
    tf_remesh_options quiet = {.edge = options->edge};
    tf_remesh_report counts = {0};
    tf_flow_state state = {.remesher = {.surface = surface,
                                        .edge = options->edge,
                                        .options = &quiet,
                                        .report = &counts},
                           .options = options,
                           .report = made};
    tf_status status = flow(&state, time, step);
    memcpy(made->tried, counts.tried, sizeof made->tried);
    tf_buffer_free(&state.remesher.row);
    return status;
}
