//: Include what the cubic needs
#include "linear/cubic.h"

#include "base/require.h"
#include "linear/linear_pair.h"

//: Span the common plane
/// The three vectors whose determinant is zero when the elements are in one
/// plane: two edges, and the way from one element to the other.
static void span(const tf_linear_pair *elements, int t, tf_vector edge[2],
                 tf_vector *way)
{
    const tf_vector *x = elements->at[t];
    bool two_edges = elements->vertices == 2;
    edge[0] = tf_vector_difference(x[two_edges ? 1 : 2], x[two_edges ? 0 : 1]);
    edge[1] = tf_vector_difference(x[3], x[two_edges ? 2 : 1]);
    *way = tf_vector_difference(x[two_edges ? 2 : 1], x[0]);
}

//: Find the cubic of a plane
/// Each coefficient is the mean of the determinants with as many columns at
/// t = 1 as its index.
static tf_polynomial coplanarity(const tf_linear_pair *elements)
{
    tf_vector edge[2][2], way[2], normal[3];
    span(elements, 0, edge[0], &way[0]);
    span(elements, 1, edge[1], &way[1]);
    normal[0] = tf_vector_cross(edge[0][0], edge[0][1]);
    normal[1] = tf_vector_sum(tf_vector_cross(edge[0][0], edge[1][1]), 1,
                              tf_vector_cross(edge[1][0], edge[0][1]));
    normal[2] = tf_vector_cross(edge[1][0], edge[1][1]);
    double first =
        tf_vector_dot(normal[0], way[1]) + tf_vector_dot(normal[1], way[0]);
    double second =
        tf_vector_dot(normal[1], way[1]) + tf_vector_dot(normal[2], way[0]);
    return (tf_polynomial){.degree = 3,
                           .coefficient = {tf_vector_dot(normal[0], way[0]),
                                           first / 3, second / 3,
                                           tf_vector_dot(normal[2], way[1])}};
}

//: Answer by the cubic
static tf_status solve(const tf_tolerances *tolerances, const tf_motion *motion,
                       int vertices, const int first[], int others,
                       const int second[], tf_contact *contact)
{
    TF_REQUIRE(tolerances && contact);
    if (!tf_tolerances_valid(tolerances))
        return TF_BAD_OPTION;
    tf_linear_pair elements;
    tf_status status = tf_linear_pair_take(3, motion, vertices, first, others,
                                           second, &elements);
    if (status != TF_OK)
        return status;
    tf_polynomial cubic = coplanarity(&elements);
    *contact = tf_linear_pair_touch(&elements, &cubic, tolerances);
    return TF_OK;
}

//: Answer the queries in space by the cubic
tf_status tf_cubic_point_triangle(const tf_tolerances *tolerances,
                                  const tf_motion *motion, int point,
                                  const int triangle[3], tf_contact *contact)
{
    return solve(tolerances, motion, 1, &point, 3, triangle, contact);
}

tf_status tf_cubic_edge_edge(const tf_tolerances *tolerances,
                             const tf_motion *motion, const int first[2],
                             const int second[2], tf_contact *contact)
{
    return solve(tolerances, motion, 2, first, 2, second, contact);
}
