//: Include what a flow needs
#include "flow/flow.h"

#include "base/environment.h"
#include "base/memory.h"
#include "base/require.h"
#include "flow/flow_state.h"
#include "flow/keep_volume.h"
#include "remesh/passes.h"
#include "topology/passes.h"

#include <math.h>
#include <string.h>

//: Create a flow
tf_status tf_flow_create(tf_adaptive_surface *surface, tf_flow **flow)
{
    TF_REQUIRE(surface && flow);
    tf_flow *made = tf_allocate_zeroed(sizeof *made);
    if (!made)
        return TF_OUT_OF_MEMORY;
    made->remesher.surface = surface;
    made->remesher.policy = &tf_keep_volume;
    made->reconnector.surface = surface;
    made->advance.surface = surface;
    *flow = made;
    return TF_OK;
}

void tf_flow_free(tf_flow *flow)
{
    if (!flow)
        return;
    tf_remesher_free(&flow->remesher);
    tf_reconnector_free(&flow->reconnector);
    tf_advance_free(&flow->advance);
    tf_release(flow, sizeof *flow);
}

//: Count the memory of a flow
size_t tf_flow_memory(const tf_flow *flow)
{
    TF_REQUIRE(flow);
    return sizeof *flow + tf_remesher_memory(&flow->remesher) +
           tf_reconnector_memory(&flow->reconnector) +
           tf_advance_memory(&flow->advance);
}

//: Improve a surface that flows
static tf_status improve(tf_flow *flow, const tf_flow_options *options,
                         tf_flow_report *report)
{
    tf_remesher *remesher = &flow->remesher;
    remesher->options = (tf_remesh_options){.edge = options->edge};
    remesher->report = (tf_remesh_report){0};
    memset(remesher->restored, 0, sizeof remesher->restored);
    tf_status status = tf_remesh_round(remesher);
    memcpy(report->tried, remesher->report.tried, sizeof report->tried);
    memcpy(report->shifted, remesher->restored, sizeof report->shifted);
    return status;
}

//: Reconnect a surface that flows
static tf_status reconnect(tf_flow *flow, const tf_flow_options *options,
                           tf_flow_report *report)
{
    tf_reconnect_options lengths = {.edge = options->edge};
    return options->keep_topology
               ? TF_OK
               : tf_reconnect_passes(&flow->reconnector, &lengths,
                                     &report->reconnected);
}

//: Advance a surface that flows
static tf_status move(tf_flow *flow, const tf_flow_options *options,
                      double time, double step, tf_flow_report *report)
{
    tf_flow_advance *advance = &flow->advance;
    tf_status status = tf_adaptive_compact(advance->surface, NULL);
    if (status != TF_OK || advance->surface->triangles == 0)
        return status;
    status = tf_advance_begin(advance, options, time, step);
    if (status != TF_OK)
        return status;
    tf_advance_propose(advance);
    tf_advance_restore_volume(advance);
    return tf_advance_resolve(advance, &report->response);
}

//: Go through the parts of a step
static double clock_of(const tf_flow_options *options)
{
    return options->clock ? options->clock() : 0;
}

static tf_status make_step(tf_flow *flow, const tf_flow_options *options,
                           double time, double step, tf_flow_report *report)
{
    double begin[TF_FLOW_PARTS + 1] = {clock_of(options)};
    tf_status status = improve(flow, options, report);
    begin[TF_RECONNECT] = clock_of(options);
    if (status == TF_OK)
        status = reconnect(flow, options, report);
    begin[TF_ADVANCE] = clock_of(options);
    if (status == TF_OK)
        status = move(flow, options, time, step, report);
    begin[TF_FLOW_PARTS] = clock_of(options);
    for (int i = 0; i < TF_FLOW_PARTS; i++)
        report->seconds[i] = begin[i + 1] - begin[i];
    return status;
}

//: Make a step of a flow
tf_status tf_flow_step(tf_flow *flow, const tf_flow_options *options,
                       double time, double step, tf_flow_report *report)
{
    TF_REQUIRE(flow && options && options->velocity);
    if (!tf_environment_is_ieee())
        return TF_BAD_ENVIRONMENT;
    if (!(options->edge > 0) || !isfinite(options->edge))
        return TF_BAD_OPTION;
    tf_flow_report unused = {0};
    report = report ? report : &unused;
    *report = (tf_flow_report){0};
    return make_step(flow, options, time, step, report);
}
