//: Include what distances of elements need
#include "distance/distance.h"

#include "base/environment.h"
#include "base/require.h"
#include "distance/nearer.h"
#include "distance/nearest.h"
#include "query/shape.h"

#include <math.h>
#include <stddef.h>

//: Take elements at rest
/// Whether an index is that of a vertex and none of those before it.
static bool is_new_index(int vertices, const int vertex[], int i)
{
    bool good = vertex[i] >= 0 && vertex[i] < vertices;
    for (int j = 0; j < i; j++)
        good = good && vertex[j] != vertex[i];
    return good;
}

static tf_status take_at_rest(tf_kind kind, int vertices,
                              const double position[], const int vertex[],
                              const double *x[4])
{
    TF_REQUIRE(position && vertex);
    const tf_query_shape *shape = tf_query_shape_of(kind);
    if (!shape)
        return TF_BAD_OPTION;
    if (!tf_environment_is_ieee())
        return TF_BAD_ENVIRONMENT;
    for (int i = 0; i < shape->vertices + shape->others; i++) {
        if (!is_new_index(vertices, vertex, i))
            return TF_BAD_INDEX;
        x[i] = position + (ptrdiff_t)shape->axes * vertex[i];
        for (int k = 0; k < shape->axes; k++)
            if (!isfinite(x[i][k]))
                return TF_NOT_FINITE;
    }
    return TF_OK;
}

//: Ask for a distance
tf_status tf_distance(tf_kind kind, int vertices, const double position[],
                      const int vertex[], tf_nearest *nearest)
{
    TF_REQUIRE(nearest);
    const double *x[4];
    tf_status status = take_at_rest(kind, vertices, position, vertex, x);
    if (status == TF_OK)
        *nearest = tf_nearest_of(kind, x);
    return status;
}

tf_status tf_is_nearer(tf_kind kind, int vertices, const double position[],
                       const int vertex[], double length, bool *nearer)
{
    TF_REQUIRE(nearer);
    const double *x[4];
    tf_status status = take_at_rest(kind, vertices, position, vertex, x);
    if (status == TF_OK && !(length > 0 && isfinite(length)))
        status = TF_BAD_OPTION;
    if (status == TF_OK)
        *nearer = tf_are_nearer(kind, x, length);
    return status;
}
