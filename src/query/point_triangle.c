//: Ask the point-triangle query
#include "query/point_triangle.h"

tf_status tf_point_triangle(const tf_arithmetic *arithmetic,
                            const tf_worldline *point,
                            const tf_worldline triangle[3], tf_contact *contact)
{
    return tf_query(arithmetic, 3, 1, point, 3, triangle, contact);
}
