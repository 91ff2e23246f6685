//: Declare the edge-edge query
#ifndef TF_QUERY_EDGE_EDGE_H
#define TF_QUERY_EDGE_EDGE_H

#include "query/contact.h"

/// Whether, when and how two moving edges first meet in space.  See tf_query.
tf_status tf_edge_edge(const tf_arithmetic *arithmetic,
                       const tf_worldline first[2],
                       const tf_worldline second[2], tf_contact *contact);

#endif
