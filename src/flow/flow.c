//: Include what a flow needs
#include "flow/flow.h"

#include "base/environment.h"
#include "base/memory.h"
#include "base/require.h"
#include "base/sized.h"
#include "flow/flow_state.h"
#include "flow/keep_volume.h"
#include "remesh/measure.h"
#include "remesh/passes.h"
#include "surface/tasks.h"
#include "surgery/draft.h"
#include "surgery/frozen.h"
#include "topology/passes.h"

#include <stddef.h>
#include <string.h>

//: Create a flow
tf_status tf_flow_create(tf_adaptive_surface *surface, tf_flow **flow)
{
    TF_REQUIRE(surface && flow);
    tf_flow *made = tf_allocate_zeroed(sizeof *made);
    if (!made)
        return TF_OUT_OF_MEMORY;
    made->surface = surface;
    made->remesher.surface = &made->draft;
    made->remesher.policy = &tf_keep_volume;
    made->reconnector.surface = &made->draft;
    made->advance.surface = &made->draft;
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
    tf_draft_free(&flow->draft);
    tf_release(flow, sizeof *flow);
}

//: Count the memory of a flow
size_t tf_flow_memory(const tf_flow *flow)
{
    TF_REQUIRE(flow);
    return sizeof *flow - sizeof flow->draft +
           tf_adaptive_memory(&flow->draft) +
           tf_remesher_memory(&flow->remesher) +
           tf_reconnector_memory(&flow->reconnector) +
           tf_advance_memory(&flow->advance);
}

//: Improve a surface that flows
static tf_status improve(tf_flow *flow, const tf_flow_options *options)
{
    tf_remesher *remesher = &flow->remesher;
    remesher->edge = options->edge * flow->surface->scale;
    remesher->report = (tf_remesh_report){0};
    memset(remesher->restored, 0, sizeof remesher->restored);
    tf_watch *watch = flow->draft.watch;
    tf_watch_stage(watch, "copying", 0);
    tf_status status = tf_draft_begin(&flow->draft, flow->surface, watch);
    if (status == TF_OK)
        status = tf_sharp_edges_find(&remesher->sharp, &flow->draft,
                                     &tf_sharp_boundary, watch);
    if (status == TF_OK)
        status = tf_remesh_round(remesher);
    memcpy(flow->report.tried, remesher->report.tried,
           sizeof flow->report.tried);
    memcpy(flow->report.shifted, remesher->restored,
           sizeof flow->report.shifted);
    return status;
}

//: Reconnect a surface that flows
static tf_status reconnect(tf_flow *flow, const tf_flow_options *options)
{
    flow->reconnector.report = (tf_reconnect_report){0};
    return options->keep_topology ? TF_OK
                                  : tf_reconnect_passes(&flow->reconnector);
}

//: Advance a surface that flows
static tf_status move(tf_flow *flow, const tf_flow_options *options,
                      double time, double step)
{
    tf_flow_advance *advance = &flow->advance;
    tf_watch_stage(flow->draft.watch, "advancing", 0);
    tf_status status = tf_adaptive_compact(advance->surface, NULL);
    if (status != TF_OK || advance->surface->triangles == 0)
        return status;
    status = tf_advance_begin(advance, options, time, step);
    if (status == TF_OK)
        status = tf_advance_propose(advance);
    if (status == TF_OK)
        status = tf_advance_restore_volume(advance);
    return status == TF_OK ? tf_advance_resolve(advance, &flow->report.response)
                           : status;
}

//: Go through the parts of a step
static double clock_of(const tf_flow_options *options)
{
    return options->clock ? options->clock(options->context) : 0;
}

static tf_status make_step(tf_flow *flow, const tf_flow_options *options,
                           double time, double step)
{
    double begin[] = {clock_of(options), 0, 0, 0};
    tf_status status = improve(flow, options);
    begin[TF_RECONNECT] = clock_of(options);
    if (status == TF_OK)
        status = reconnect(flow, options);
    begin[TF_ADVANCE] = clock_of(options);
    if (status == TF_OK)
        status = move(flow, options, time, step);
    if (status == TF_OK)
        tf_draft_accept(&flow->draft, flow->surface);
    begin[TF_ADVANCE + 1] = clock_of(options);
    for (int i = TF_IMPROVE; i <= TF_ADVANCE; i++)
        flow->report.seconds[i] = begin[i + 1] - begin[i];
    return status;
}

//: Read how a surface flows
static tf_status read_options(tf_flow_options *own,
                              const tf_flow_options *options, tf_flow *flow,
                              tf_error *error)
{
    size_t first = offsetof(tf_flow_options, context) + sizeof own->context;
    tf_status status = tf_options_read(own, sizeof *own, options, first, error);
    if (status != TF_OK)
        return status;
    TF_REQUIRE(own->velocity);
    status = tf_check_freedom(flow->surface, error);
    if (status != TF_OK)
        return status;
    tf_reconnect_options unread, lengths = {.edge = own->edge};
    tf_choose_scale(flow->surface);
    status = tf_reconnect_options_read(&unread, &lengths, flow->surface->scale,
                                       &flow->reconnector.lengths, error);
    if (status == TF_OK)
        status =
            tf_check_coordinates(flow->surface, TF_MOST_FOR_VOLUMES, error);
    if (status == TF_OK)
        status = tf_check_target(flow->surface, own->edge, error);
    return status == TF_OK ? tf_parallel_check(own->parallel, error) : status;
}

//: Make a step of a flow
tf_status tf_flow_step(tf_flow *flow, double time, double step,
                       const tf_flow_options *options,
                       const tf_flow_report **report, tf_error *error)
{
    TF_REQUIRE(flow && options);
    if (!tf_environment_is_ieee())
        return tf_fail(error, TF_BAD_ENVIRONMENT);
    tf_flow_options own;
    tf_status status = read_options(&own, options, flow, error);
    if (status != TF_OK)
        return status;
    tf_watch watch;
    flow->draft.watch = tf_watch_begin(&watch, own.progress, own.context);
    flow->report = (tf_flow_report){.reconnected = &flow->reconnector.report,
                                    .response = &flow->no_response};
    status = make_step(flow, &own, time, step);
    flow->draft.watch = NULL;
    if (status == TF_OK && report)
        *report = &flow->report;
    return tf_fail(error, status);
}
