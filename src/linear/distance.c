//: Include what distances need
#include "linear/distance.h"

#include "base/require.h"

#include <math.h>
#include <string.h>

//: Measure the gap between two points
static double gap_between(int vertices, int others, const tf_vector x[],
                          const double weight[])
{
    // Relative to a vertex, where the coordinates have fewer digits to lose.
    tf_vector gap = {{0}};
    for (int i = 1; i < vertices + others; i++) {
        double signed_weight = i < vertices ? weight[i] : -weight[i];
        tf_vector from = tf_vector_difference(x[i], x[0]);
        gap = tf_vector_sum(gap, signed_weight, from);
    }
    return tf_vector_length(gap);
}

//: Keep the nearer of two pairs of points
/// What all points are nearer than: the first vertices.
static tf_point_pair far_apart(int vertices)
{
    tf_point_pair far = {.distance = INFINITY};
    far.weight[0] = far.weight[vertices] = 1;
    return far;
}

static void keep_nearer(tf_point_pair *best, const tf_point_pair *other)
{
    if (other->distance < best->distance)
        *best = *other;
}

//: Find the point of a segment nearest to a point
/// Of x[start] to x[end] the point nearest to x[point].
static void visit_segment(const tf_vector x[], int point, int start, int end,
                          tf_point_pair *best)
{
    tf_vector edge = tf_vector_difference(x[end], x[start]);
    tf_vector gap = tf_vector_difference(x[point], x[start]);
    double length2 = tf_vector_dot(edge, edge);
    double along = length2 > 0 ? tf_vector_dot(gap, edge) / length2 : 0;
    along = fmin(fmax(along, 0), 1);
    gap = tf_vector_sum(gap, -along, edge);

    tf_point_pair found = {.distance = tf_vector_length(gap)};
    found.weight[point] = 1;
    found.weight[start] = 1 - along;
    found.weight[end] = along;
    keep_nearer(best, &found);
}

//: Find where a point lies over a triangle
/// Divides `count` coordinates by their sum, which is 1 but for rounding.
/// False where that has left nothing of them.
static bool normalize(int count, double weight[])
{
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += weight[i];
    for (int i = 0; i < count; i++)
        weight[i] /= sum;
    return sum > 0.5 && sum < 2;
}

static bool weigh_triangle(const tf_vector x[4], double weight[4])
{
    tf_vector normal = tf_vector_cross(tf_vector_difference(x[2], x[1]),
                                       tf_vector_difference(x[3], x[1]));
    double area2 = tf_vector_dot(normal, normal);
    weight[0] = 1;
    for (int i = 0; i < 3; i++) {
        tf_vector b = tf_vector_difference(x[1 + (i + 1) % 3], x[0]);
        tf_vector c = tf_vector_difference(x[1 + (i + 2) % 3], x[0]);
        weight[1 + i] = tf_vector_dot(tf_vector_cross(b, c), normal) / area2;
    }
    return normalize(3, weight + 1);
}

//: Find where two lines are nearest
static bool weigh_edges(const tf_vector x[4], double weight[4])
{
    tf_vector first = tf_vector_difference(x[1], x[0]);
    tf_vector second = tf_vector_difference(x[3], x[2]);
    tf_vector between = tf_vector_difference(x[2], x[0]);
    tf_vector normal = tf_vector_cross(first, second);
    double area2 = tf_vector_dot(normal, normal);
    if (!(area2 > 0))
        return false;
    weight[1] = tf_vector_dot(tf_vector_cross(between, second), normal) / area2;
    weight[3] = tf_vector_dot(tf_vector_cross(between, first), normal) / area2;
    weight[0] = 1 - weight[1];
    weight[2] = 1 - weight[3];
    return true;
}

//: Find the foot of a perpendicular
static bool weigh_segment(const tf_vector x[3], double weight[3])
{
    tf_vector edge = tf_vector_difference(x[2], x[1]);
    double length2 = tf_vector_dot(edge, edge);
    weight[0] = 1;
    weight[1] = tf_vector_dot(tf_vector_difference(x[2], x[0]), edge) / length2;
    weight[2] = tf_vector_dot(tf_vector_difference(x[0], x[1]), edge) / length2;
    return normalize(2, weight + 1);
}

//: Find where elements cross
bool tf_crossing_weights(int vertices, int others, const tf_vector x[],
                         double weight[])
{
    if (vertices == 2)
        return weigh_edges(x, weight);
    return others == 3 ? weigh_triangle(x, weight) : weigh_segment(x, weight);
}

bool tf_weights_reach(int count, const double weight[], double least)
{
    for (int i = 0; i < count; i++)
        if (!(weight[i] >= least))
            return false;
    return true;
}

//: Find the nearest points of small elements
/// The least distance is between the insides, or involves a boundary.
static tf_point_pair nearest_of_four(int vertices, int others,
                                     const tf_vector x[])
{
    tf_point_pair best = far_apart(vertices), inside = {0};
    if (vertices == 2) {
        for (int i = 0; i < 2; i++) {
            visit_segment(x, i, 2, 3, &best);
            visit_segment(x, 2 + i, 0, 1, &best);
        }
    } else {
        for (int i = 0; i < others; i++)
            visit_segment(x, 0, 1 + i, 1 + (i + 1) % others, &best);
    }
    int count = vertices + others;
    if (tf_crossing_weights(vertices, others, x, inside.weight) &&
        tf_weights_reach(count, inside.weight, 0)) {
        inside.distance = gap_between(vertices, others, x, inside.weight);
        keep_nearer(&best, &inside);
    }
    return best;
}

//: Find the nearest points of parts of triangles
/// Of the first `count` vertices in `corner` as one part, and the others as
/// another part, of two triangles x[0..2] and x[3..5].
static void visit_parts(const tf_vector *x, int count, const int corner[4],
                        tf_point_pair *best)
{
    tf_vector part[4];
    for (int i = 0; i < 4; i++)
        part[i] = x[corner[i]];
    tf_point_pair among = nearest_of_four(count, 4 - count, part);
    tf_point_pair found = {.distance = among.distance};
    for (int i = 0; i < 4; i++)
        found.weight[corner[i]] = among.weight[i];
    keep_nearer(best, &found);
}

//: Find where an edge pierces a triangle
/// Sets a distance of zero if the edge from x[start] to x[end] goes through the
/// triangle x[from..from+2].
static void visit_piercing(const tf_vector *x, int start, int end, int from,
                           tf_point_pair *best)
{
    const tf_vector *corner = x + from;
    tf_vector normal =
        tf_vector_cross(tf_vector_difference(corner[1], corner[0]),
                        tf_vector_difference(corner[2], corner[0]));
    double low = tf_vector_dot(normal, tf_vector_difference(x[start], *corner));
    double high = tf_vector_dot(normal, tf_vector_difference(x[end], *corner));
    if (!((low < 0 && high > 0) || (low > 0 && high < 0)))
        return;
    double along = low / (low - high), weight[4];
    tf_vector point =
        tf_vector_sum(tf_vector_scaled(1 - along, x[start]), along, x[end]);
    tf_vector over[4] = {point, corner[0], corner[1], corner[2]};
    if (!weigh_triangle(over, weight) || !tf_weights_reach(4, weight, 0))
        return;
    *best = (tf_point_pair){.distance = 0};
    best->weight[start] = 1 - along;
    best->weight[end] = along;
    memcpy(best->weight + from, weight + 1, 3 * sizeof *weight);
}

//: Find the nearest points of two triangles
static tf_point_pair nearest_of_triangles(const tf_vector *x)
{
    tf_point_pair best = far_apart(3);
    for (int i = 0; i < 3; i++) {
        int next = (i + 1) % 3;
        visit_parts(x, 1, (int[]){i, 3, 4, 5}, &best);
        visit_parts(x, 1, (int[]){3 + i, 0, 1, 2}, &best);
        for (int j = 0; j < 3; j++)
            visit_parts(x, 2, (int[]){i, next, 3 + j, 3 + (j + 1) % 3}, &best);
    }
    for (int i = 0; i < 3; i++) {
        visit_piercing(x, i, (i + 1) % 3, 3, &best);
        visit_piercing(x, 3 + i, 3 + (i + 1) % 3, 0, &best);
    }
    return best;
}

//: Find nearest points
tf_point_pair tf_nearest_points(int vertices, int others, const tf_vector x[])
{
    TF_REQUIRE(vertices + others <= 4 || (vertices == 3 && others == 3));
    return vertices == 3 ? nearest_of_triangles(x)
                         : nearest_of_four(vertices, others, x);
}

//: Find the distance of a point from a triangle
/// Whether rounding leaves little of a triangle's normal, whose square is
/// `area2`.
static bool is_sliver(const tf_vector x[4], double area2)
{
    tf_vector side = tf_vector_difference(x[2], x[1]);
    tf_vector other = tf_vector_difference(x[3], x[1]);
    double length2 = tf_vector_dot(side, side) + tf_vector_dot(other, other);
    return !(area2 > 0x1p-60 * length2 * length2);
}

/// The square of the distance from an edge, at whose start the gap begins.
static double squared_from_edge(tf_vector edge, tf_vector gap)
{
    double along = tf_vector_dot(gap, edge);
    double length2 = tf_vector_dot(edge, edge);
    double part = along <= 0 ? 0 : along >= length2 ? 1 : along / length2;
    gap = tf_vector_sum(gap, -part, edge);
    return tf_vector_dot(gap, gap);
}

/// From the edges that the point is beyond, or else from the plane.
double tf_squared_distance(const tf_vector x[4])
{
    tf_vector normal = tf_vector_cross(tf_vector_difference(x[2], x[1]),
                                       tf_vector_difference(x[3], x[1]));
    tf_vector gap = {{0}};
    double area2 = tf_vector_dot(normal, normal), least = INFINITY;
    if (is_sliver(x, area2)) {
        double distance = tf_nearest_points(1, 3, x).distance;
        return distance * distance;
    }
    for (int i = 0; i < 3; i++) {
        tf_vector edge = tf_vector_difference(x[1 + (i + 1) % 3], x[1 + i]);
        gap = tf_vector_difference(x[0], x[1 + i]);
        if (tf_vector_dot(tf_vector_cross(edge, gap), normal) < 0) {
            double from_edge = squared_from_edge(edge, gap);
            least = from_edge < least ? from_edge : least;
        }
    }
    double height = tf_vector_dot(gap, normal);
    return isfinite(least) ? least : height * height / area2;
}
