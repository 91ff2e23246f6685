//: Decide one query after another
#include "query/narrow_phase.h"

#include "base/environment.h"
#include "base/require.h"
#include "query/query.h"
#include "query/shape.h"

#include <stdbool.h>

static tf_status decide_queries(void *context, const tf_arithmetic *arithmetic,
                                const tf_queries *queries, tf_verdict verdict[],
                                size_t *separated)
{
    (void)context;
    TF_REQUIRE(arithmetic && queries && separated);
    TF_REQUIRE((queries->vertices && verdict) || queries->count == 0);
    const tf_query_shape *pair = tf_query_shape_of(queries->kind);
    if (!pair)
        return TF_BAD_OPTION;
    if (queries->count > 0 && !tf_environment_is_ieee())
        return TF_BAD_ENVIRONMENT;
    const int *first = queries->vertices;
    for (size_t i = 0; i < queries->count; i++) {
        const int *second = first + pair->vertices;
        bool by_axis = false;
        tf_status status = tf_query_verdict(
            arithmetic, pair->axes, queries->motion, pair->vertices, first,
            pair->others, second, &verdict[i], &by_axis);
        if (status != TF_OK)
            return status;
        *separated += by_axis;
        first = second + pair->others;
    }
    return TF_OK;
}

const tf_narrow_phase tf_reference = {.name = "reference",
                                      .decide = decide_queries};
