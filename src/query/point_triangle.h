//: Declare the point-triangle query
#ifndef TF_QUERY_POINT_TRIANGLE_H
#define TF_QUERY_POINT_TRIANGLE_H

#include "query/contact.h"

/// Whether, when and how a moving point first meets a moving triangle in
/// space.  See tf_query.
tf_status tf_point_triangle(const tf_arithmetic *arithmetic,
                            const tf_worldline *point,
                            const tf_worldline triangle[3],
                            tf_contact *contact);

#endif
