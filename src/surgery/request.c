//: Check a request
#include "surgery/request.h"

#include "base/environment.h"
#include "base/require.h"

#include <math.h>

tf_status tf_request_check(const tf_adaptive *of, int a, int b,
                           const double place[], tf_outcome *outcome)
{
    TF_REQUIRE(of && outcome);
    *outcome = TF_NO_OUTCOME;
    if (!tf_environment_is_ieee())
        return TF_BAD_ENVIRONMENT;
    if (a < 0 || a >= of->vertices || b < 0 || b >= of->vertices)
        return TF_BAD_INDEX;
    for (int k = 0; place && k < 3; k++)
        if (!isfinite(place[k]))
            return TF_NOT_FINITE;
    return TF_OK;
}
