//: Solve the quadratic
#include "linear/quadratic.h"

#include "base/require.h"
#include "linear/linear_pair.h"

/// Twice the area of the triangle of two vectors of the plane.
static double area_of(tf_vector a, tf_vector b)
{
    return a.x[0] * b.x[1] - a.x[1] * b.x[0];
}

/// The quadratic that is zero when the point is on the edge's line.
static tf_polynomial collinearity(const tf_linear_pair *elements)
{
    tf_vector a[2], b[2];
    for (int t = 0; t < 2; t++) {
        a[t] = tf_vector_difference(elements->at[t][1], elements->at[t][0]);
        b[t] = tf_vector_difference(elements->at[t][2], elements->at[t][0]);
    }
    return (tf_polynomial){
        .degree = 2,
        .coefficient = {area_of(a[0], b[0]),
                        (area_of(a[0], b[1]) + area_of(a[1], b[0])) / 2,
                        area_of(a[1], b[1])}};
}

//: Answer the point-edge query by the quadratic
tf_status tf_quadratic_point_edge(const tf_tolerances *tolerances,
                                  const tf_motion *motion, int point,
                                  const int edge[2], tf_contact *contact)
{
    TF_REQUIRE(tolerances && contact);
    if (!tf_tolerances_valid(tolerances))
        return TF_BAD_OPTION;
    tf_linear_pair elements;
    tf_status status =
        tf_linear_pair_take(2, motion, 1, &point, 2, edge, &elements);
    if (status != TF_OK)
        return status;
    tf_polynomial quadratic = collinearity(&elements);
    *contact = tf_linear_pair_touch(&elements, &quadratic, tolerances);
    return TF_OK;
}
