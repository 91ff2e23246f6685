//: Include what a flow needs
#include "flow/flowing.h"

#include "base/environment.h"
#include "base/require.h"

#include <math.h>
#include <string.h>

enum {
    IMPROVING_PASSES = 3 ///< at most, of splits and of flips
};

//: Recognize what keeps the volume
bool tf_flowing_keeps(const tf_flowing *of, tf_operation operation)
{
    return (of->options->careless >> operation & 1) == 0;
}

//: Repeat a pass
/// Until it does nothing, or for the last time.
static tf_status repeat_pass(tf_flowing *of, tf_operation operation,
                             tf_status pass(tf_flowing *of))
{
    const size_t *done = &of->remesher.report->tried[operation][TF_COMMITTED];
    tf_status status = TF_OK;
    size_t before = *done - 1;
    for (int i = 0; i < IMPROVING_PASSES && status == TF_OK && *done != before;
         i++) {
        before = *done;
        status = pass(of);
    }
    return status;
}

//: Improve a surface that flows
static tf_status improve(tf_flowing *of)
{
    tf_status status = repeat_pass(of, TF_SPLIT, tf_refine_pass);
    if (status == TF_OK)
        status = repeat_pass(of, TF_FLIP, tf_turn_pass);
    if (status == TF_OK)
        status = tf_coarsen_pass(of);
    return status == TF_OK ? tf_relax_pass(of) : status;
}

//: Go through the parts of a step
static double clock_of(const tf_flowing *of)
{
    return of->options->clock ? of->options->clock() : 0;
}

static tf_status reconnect(tf_flowing *of)
{
    tf_reconnect_options options = {.edge = of->options->edge};
    return of->options->keep_topology
               ? TF_OK
               : tf_adaptive_reconnect(of->remesher.of, &options,
                                       &of->report->reconnected);
}

static tf_status flow(tf_flowing *of, double time, double step)
{
    double begin[TF_FLOW_PARTS + 1] = {clock_of(of)};
    tf_status status = improve(of);
    begin[TF_RECONNECT] = clock_of(of);
    if (status == TF_OK)
        status = reconnect(of);
    begin[TF_ADVANCE] = clock_of(of);
    if (status == TF_OK)
        status = tf_advect(of, time, step);
    begin[TF_FLOW_PARTS] = clock_of(of);
    for (int i = 0; i < TF_FLOW_PARTS; i++)
        of->report->seconds[i] = begin[i + 1] - begin[i];
    return status;
}

//: Make a step of a flow
tf_status tf_adaptive_flow(tf_adaptive *surface, const tf_flow_options *options,
                           double time, double step, tf_flow_report *report)
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
    tf_flowing of = {.remesher = {.of = surface,
                                  .edge = options->edge,
                                  .options = &quiet,
                                  .report = &counts},
                     .options = options,
                     .report = made};
    tf_status status = flow(&of, time, step);
    memcpy(made->tried, counts.tried, sizeof made->tried);
    tf_buffer_free(&of.remesher.row);
    return status;
}
