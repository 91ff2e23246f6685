//: Decide one query after another
#include "query/narrow_phase.h"

#include "base/environment.h"
#include "base/require.h"
#include "query/query.h"

#include <stdbool.h>

/// The axes of the scene and the vertices of the two elements.
typedef struct shape {
    int axes, vertices, others;
} shape;

/// NULL: there is no such kind.
static const shape *shape_of(tf_kind kind)
{
    static const shape shapes[] = {
        [TF_POINT_EDGE] = {2, 1, 2},
        [TF_POINT_TRIANGLE] = {3, 1, 3},
        [TF_EDGE_EDGE] = {3, 2, 2},
    };
    bool known = kind > TF_NO_KIND && kind <= TF_EDGE_EDGE;
    return known ? &shapes[kind] : NULL;
}

static tf_status decide_queries(void *context, const tf_arithmetic *arithmetic,
                                const tf_queries *queries, tf_verdict verdict[],
                                size_t *separated)
{
    (void)context;
    TF_REQUIRE(arithmetic && queries && separated);
    TF_REQUIRE((queries->vertices && verdict) || queries->count == 0);
    const shape *pair = shape_of(queries->kind);
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
