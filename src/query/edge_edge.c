//: Answer the edge-edge query
#include "query/edge_edge.h"

#include "query/query.h"

tf_status tf_edge_edge(const tf_arithmetic *arithmetic, const tf_motion *motion,
                       const int first[2], const int second[2],
                       tf_contact *contact)
{
    return tf_query_motion(arithmetic, 3, motion, 2, first, 2, second, contact);
}
