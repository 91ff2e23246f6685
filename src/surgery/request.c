//: Check a request
#include "surgery/request.h"

#include "base/environment.h"
#include "base/require.h"

#include <math.h>

tf_status tf_request_check(const tf_adaptive_surface *surface, int a, int b,
                           const double position[], tf_outcome *outcome)
{
    TF_REQUIRE(surface && outcome);
    *outcome = TF_NO_OUTCOME;
    if (!tf_environment_is_ieee())
        return TF_BAD_ENVIRONMENT;
    if (a < 0 || a >= surface->vertices || b < 0 || b >= surface->vertices)
        return TF_BAD_INDEX;
    for (int k = 0; position && k < 3; k++)
        if (!isfinite(position[k]))
            return TF_NOT_FINITE;
    return TF_OK;
}
