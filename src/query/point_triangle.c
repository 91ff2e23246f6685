//: Answer the point-triangle query
#include "query/point_triangle.h"

#include "query/query.h"

tf_status tf_point_triangle(const tf_arithmetic *arithmetic,
                            const tf_motion *motion, int point,
                            const int triangle[3], tf_contact *contact)
{
    return tf_query_motion(arithmetic, 3, motion, 1, &point, 3, triangle,
                           contact);
}
