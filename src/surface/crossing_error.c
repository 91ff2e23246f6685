//: Set an error about an intersection
#include "surface/crossing_error.h"

#include "base/fail.h"

tf_status tf_fail_crossing(tf_error *error, tf_status status,
                           const tf_crossing *crossing, int time)
{
    static const tf_subject subjects[] = {
        [TF_EDGE_THROUGH_TRIANGLE] = TF_EDGE_TRIANGLE_PAIR,
        [TF_POINT_ON_TRIANGLE] = TF_POINT_TRIANGLE_PAIR,
        [TF_EDGE_ON_EDGE] = TF_EDGE_EDGE_PAIR,
    };
    return tf_fail_pair(error, status, subjects[crossing->kind], 5,
                        crossing->vertex, time);
}
