//: Check how to reconnect
#include "topology/passes.h"

#include "topology/drop_pass.h"
#include "topology/merge_pass.h"
#include "topology/pinch_pass.h"

static bool is_length(double x)
{
    return x >= 0 && isfinite(x);
}

static bool are_good(const tf_reconnect_options *options)
{
    return options->edge > 0 && isfinite(options->edge) &&
           is_length(options->merge) && is_length(options->patch) &&
           is_length(options->pinch) && is_length(options->drop);
}

//: Scale the lengths
static double or_usual(double x, double usual)
{
    return x > 0 ? x : usual;
}

static tf_reconnect_options scaled(const tf_reconnect_options *options)
{
    double edge = options->edge, merge = or_usual(options->merge, 0.3);
    return (tf_reconnect_options){
        .edge = edge,
        .merge = edge * merge,
        .patch = edge * fmax(or_usual(options->patch, 0.5), merge),
        .pinch = edge * or_usual(options->pinch, 0.7),
        .drop = edge * edge * edge * or_usual(options->drop, 0.5)};
}

//: Go through all passes of a reconnection
tf_status tf_reconnect_passes(tf_reconnector *reconnector,
                              const tf_reconnect_options *options,
                              tf_reconnect_report *report)
{
    if (!are_good(options))
        return TF_BAD_OPTION;
    reconnector->options = scaled(options);
    reconnector->report = report;
    tf_status status = tf_merge_pass(reconnector);
    if (status == TF_OK)
        status = tf_pinch_pass(reconnector);
    return status == TF_OK ? tf_drop_pass(reconnector) : status;
}
