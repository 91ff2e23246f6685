//: Read how to reconnect
#include "topology/passes.h"

#include "base/sized.h"
#include "topology/drop_pass.h"
#include "topology/merge_pass.h"
#include "topology/pinch_pass.h"

#include <math.h>
#include <stddef.h>

static tf_status check_lengths(const tf_reconnect_options *options,
                               tf_error *error)
{
    static const char *const names[] = {"merge", "patch", "pinch", "drop"};
    const double length[] = {options->merge, options->patch, options->pinch,
                             options->drop};
    double edge = options->edge;
    if (!(edge > 0) || !isfinite(edge))
        return tf_fail_option(error, "edge", "above 0", edge);
    for (int i = 0; i < 4; i++)
        if (!isfinite(length[i]))
            return tf_fail_option(error, names[i], "finite", length[i]);
    return tf_fail(error, TF_OK);
}

//: Scale the lengths
/// Of what is negative there is none.
static double or_usual(double x, double usual)
{
    return x == 0 ? usual : fmax(x, 0);
}

static tf_reconnect_lengths scaled(const tf_reconnect_options *options,
                                   double scale)
{
    const double usual = 0.3;
    double edge = options->edge * scale;
    double merge = or_usual(options->merge, usual);
    return (tf_reconnect_lengths){
        .merge = edge * merge,
        .patch = edge * fmax(or_usual(options->patch, 0.5), merge),
        .pinch = edge * or_usual(options->pinch, 0.7),
        .apart = edge * (merge > 0 ? merge : usual),
        .drop = edge * edge * edge * or_usual(options->drop, 0.5)};
}

tf_status tf_reconnect_options_read(tf_reconnect_options *own,
                                    const tf_reconnect_options *options,
                                    double scale, tf_reconnect_lengths *lengths,
                                    tf_error *error)
{
    size_t first =
        offsetof(tf_reconnect_options, context) + sizeof own->context;
    tf_status status = tf_options_read(own, sizeof *own, options, first, error);
    if (status == TF_OK)
        status = check_lengths(own, error);
    if (status == TF_OK)
        *lengths = scaled(own, scale);
    return status;
}

//: Go through all passes of a reconnection
/// Brings the volumes of a report to the user's unit.
static void report_volumes(tf_reconnector *reconnector)
{
    double length = 1 / reconnector->surface->scale;
    for (int i = 0; i < TF_RECONNECTIONS; i++)
        for (int k = 0; k < 3; k++)
            reconnector->report.gained[i] *= length;
}

tf_status tf_reconnect_passes(tf_reconnector *reconnector)
{
    const tf_reconnect_lengths *lengths = &reconnector->lengths;
    tf_status status = TF_OK;
    reconnector->report = (tf_reconnect_report){0};
    if (lengths->merge > 0)
        status = tf_merge_pass(reconnector);
    if (status == TF_OK && lengths->pinch > 0)
        status = tf_pinch_pass(reconnector);
    if (status == TF_OK && lengths->drop > 0)
        status = tf_drop_pass(reconnector);
    report_volumes(reconnector);
    return status;
}
