//: Ask the edge-edge query
#include "query/edge_edge.h"

tf_status tf_edge_edge(const tf_arithmetic *arithmetic,
                       const tf_worldline first[2],
                       const tf_worldline second[2], tf_contact *contact)
{
    return tf_query(arithmetic, 3, 2, first, 2, second, contact);
}
