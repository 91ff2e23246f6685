//: Include what the gradient needs
#include "untangle/gradient.h"

//: Find the direction of a curve within a facet
/// The direction in which the curve leaves an edge into a triangle at it: along
/// the line where the planes of the triangle and of the facet meet, towards the
/// triangle's inside.  Zero if there is none.
static tf_vector way_into(const tf_neighbors *all, const double x[],
                          const tf_curve_point *point, int triangle,
                          tf_vector along)
{
    const int *end = all->edge + 2 * (ptrdiff_t)point->edge;
    const int *corner = all->triangle + 3 * (ptrdiff_t)triangle;
    int far = corner[0] + corner[1] + corner[2] - end[0] - end[1];
    tf_vector way =
        tf_vector_cross(point->normal, tf_facet_normal(all, x, triangle));
    double length = tf_vector_length(way);
    if (length == 0)
        return way;
    tf_vector out = tf_vector_difference(tf_place(all, x, far), point->place);
    out = tf_vector_sum(out, -tf_vector_dot(out, along), along);
    double turned = tf_vector_dot(way, out) < 0 ? -1 : 1;
    return tf_vector_scaled(turned / length, way);
}

//: Find the gradient in space
static tf_vector gradient_in_space(const tf_neighbors *all, const double x[],
                                   const tf_curve_point *point)
{
    const int *end = all->edge + 2 * (ptrdiff_t)point->edge;
    tf_vector along = tf_vector_difference(tf_place(all, x, end[1]),
                                           tf_place(all, x, end[0]));
    double length = tf_vector_length(along);
    along = tf_vector_scaled(length > 0 ? 1 / length : 0, along);
    tf_vector ways = {{0, 0, 0}};
    const tf_lists *sides = &all->sides;
    for (int i = sides->start[point->edge]; i < sides->start[point->edge + 1];
         i++)
        ways = tf_vector_sum(ways, 1,
                             way_into(all, x, point, sides->item[i], along));
    double steep = tf_vector_dot(along, point->normal);
    // An edge that lies in the facet nearly would go much too far.
    if (fabs(steep) < 0.1)
        steep = steep < 0 ? -0.1 : 0.1;
    return tf_vector_sum(ways, -tf_vector_dot(along, ways) / steep,
                         point->normal);
}

//: Find the way to the end of an edge
static tf_vector way_off(const tf_neighbors *all, const double x[],
                         const tf_curve_point *point)
{
    const int *end = all->facet + 2 * (ptrdiff_t)point->facet;
    tf_vector first =
        tf_vector_difference(tf_place(all, x, end[0]), point->place);
    tf_vector second =
        tf_vector_difference(tf_place(all, x, end[1]), point->place);
    bool shorter = tf_vector_length(first) < tf_vector_length(second);
    tf_vector way = shorter ? first : second;
    double length = tf_vector_length(way);
    return tf_vector_scaled(length > 0 ? 1 / length : 0, way);
}

//: Find how much a point has of each corner
/// Barycentric coordinates of a point in a facet, each at least 0.
static void weigh_corners(const tf_neighbors *all, const double x[],
                          const tf_curve_point *point, double weight[3])
{
    const int *corner = all->facet + (ptrdiff_t)all->axes * point->facet;
    tf_vector own[3];
    double sum = 0;
    for (int i = 0; i < all->axes; i++)
        own[i] =
            tf_vector_difference(tf_place(all, x, corner[i]), point->place);
    for (int i = 0; i < all->axes; i++) {
        tf_vector next = own[(i + 1) % all->axes];
        tf_vector last = own[(i + 2) % all->axes];
        weight[i] = tf_vector_length(
            all->axes == 3 ? tf_vector_cross(next, last) : next);
        sum += weight[i];
    }
    for (int i = 0; i < all->axes; i++)
        weight[i] = sum > 0 ? weight[i] / sum : 1.0 / all->axes;
}

//: Shorten a curve
void tf_shorten_curve(tf_change *change, const tf_tangle *tangle,
                      const double x[], const tf_curve_point *point)
{
    const tf_neighbors *all = &tangle->near;
    const int *end = all->edge + 2 * (ptrdiff_t)point->edge;
    const int *corner = all->facet + (ptrdiff_t)all->axes * point->facet;
    tf_vector way = all->axes == 3 ? gradient_in_space(all, x, point)
                                   : way_off(all, x, point);
    double length = tf_vector_length(way), step = tangle->edge / 4;
    if (length == 0)
        return;
    if (length > 1)
        way = tf_vector_scaled(1 / length, way);
    tf_change_add(change, tangle, end[0], way, step, 1 - point->at);
    tf_change_add(change, tangle, end[1], way, step, point->at);
    double weight[3];
    weigh_corners(all, x, point, weight);
    for (int i = 0; i < all->axes; i++)
        tf_change_add(change, tangle, corner[i], way, -step, weight[i]);
}
