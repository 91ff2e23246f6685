//: Reconnect a draft
#include "topology/reconnect.h"

#include "base/environment.h"
#include "base/fail.h"
#include "base/require.h"
#include "remesh/measure.h"
#include "surgery/draft.h"
#include "topology/passes.h"

static tf_status reconnect(tf_reconnector *reconnector,
                           tf_adaptive_surface *surface, tf_watch *watch)
{
    tf_buffer *report = &surface->lent.reconnect_report;
    tf_watch_stage(watch, "copying", 0);
    tf_status status =
        tf_buffer_extend(report, 1, sizeof(tf_reconnect_report))
            ? tf_draft_begin(reconnector->surface, surface, watch)
            : TF_OUT_OF_MEMORY;
    if (status == TF_OK)
        status = tf_reconnect_passes(reconnector);
    if (status != TF_OK)
        return status;
    tf_draft_accept(reconnector->surface, surface);
    *(tf_reconnect_report *)report->data = reconnector->report;
    return TF_OK;
}

//: Reconnect a surface
tf_status tf_adaptive_reconnect(tf_adaptive_surface *surface,
                                const tf_reconnect_options *options,
                                const tf_reconnect_report **report,
                                tf_error *error)
{
    TF_REQUIRE(surface && options);
    if (!tf_environment_is_ieee())
        return tf_fail(error, TF_BAD_ENVIRONMENT);
    tf_adaptive_surface draft = {0};
    tf_reconnector reconnector = {.surface = &draft};
    tf_reconnect_options own;
    tf_choose_scale(surface);
    tf_status status = tf_reconnect_options_read(&own, options, surface->scale,
                                                 &reconnector.lengths, error);
    if (status == TF_OK)
        status = tf_check_coordinates(surface, TF_MOST_FOR_VOLUMES, error);
    if (status != TF_OK)
        return status;
    tf_watch watch;
    status = reconnect(&reconnector, surface,
                       tf_watch_begin(&watch, own.progress, own.context));
    tf_reconnector_free(&reconnector);
    tf_draft_free(&draft);
    if (status == TF_OK && report)
        *report = surface->lent.reconnect_report.data;
    return tf_fail(error, status);
}
