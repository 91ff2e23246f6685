//: Find the shape of a query
#include "query/shape.h"

#include <stdbool.h>
#include <stddef.h>

const tf_query_shape *tf_query_shape_of(tf_kind kind)
{
    static const tf_query_shape shapes[] = {
        [TF_POINT_EDGE] = {2, 1, 2},
        [TF_POINT_TRIANGLE] = {3, 1, 3},
        [TF_EDGE_EDGE] = {3, 2, 2},
    };
    bool known = kind > TF_NO_KIND && kind <= TF_EDGE_EDGE;
    return known ? &shapes[kind] : NULL;
}
