//: Declare the point-edge query
#ifndef TF_QUERY_POINT_EDGE_H
#define TF_QUERY_POINT_EDGE_H

#include "query/contact.h"

/// Whether, when and how a moving point first meets a moving edge in the
/// plane.  See tf_query.
tf_status tf_point_edge(const tf_arithmetic *arithmetic,
                        const tf_worldline *point, const tf_worldline edge[2],
                        tf_contact *contact);

#endif
