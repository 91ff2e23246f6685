//: Reconnect a surface
#include "topology/reconnect.h"

#include "base/environment.h"
#include "base/require.h"
#include "topology/passes.h"

tf_status tf_adaptive_reconnect(tf_adaptive_surface *surface,
                                const tf_reconnect_options *options,
                                tf_reconnect_report *report)
{
    TF_REQUIRE(surface && options);
    if (!tf_environment_is_ieee())
        return TF_BAD_ENVIRONMENT;
    tf_reconnect_report unused = {0};
    tf_reconnector reconnector = {.surface = surface};
    tf_status status =
        tf_reconnect_passes(&reconnector, options, report ? report : &unused);
    tf_reconnector_free(&reconnector);
    return status;
}
