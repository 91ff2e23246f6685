//: Ask the point-edge query
#include "query/point_edge.h"

tf_status tf_point_edge(const tf_arithmetic *arithmetic,
                        const tf_worldline *point, const tf_worldline edge[2],
                        tf_contact *contact)
{
    return tf_query(arithmetic, 2, 1, point, 2, edge, contact);
}
