//: Answer the point-edge query
#include "query/point_edge.h"

#include "query/query.h"

tf_status tf_point_edge(const tf_arithmetic *arithmetic,
                        const tf_motion *motion, int point, const int edge[2],
                        tf_contact *contact)
{
    return tf_query_motion(arithmetic, 2, motion, 1, &point, 2, edge, contact);
}
