//: Include what rigid advancement needs
#include "linear/rigid_motion.h"

#include "base/environment.h"
#include "base/require.h"
#include "geometry/sweep.h"
#include "linear/approach.h"

#include <math.h>
#include <stddef.h>

//: Turn a vector
/// About the axis of a rotation, by its angle times `time`: Rodrigues' formula.
static tf_vector turned(tf_vector rotation, double time, tf_vector r)
{
    double rate = tf_vector_length(rotation);
    if (rate == 0)
        return r;
    tf_vector axis = tf_vector_scaled(1 / rate, rotation);
    double c = cos(rate * time), s = sin(rate * time);
    double along = tf_vector_dot(axis, r) * (1 - c);
    tf_vector in_plane =
        tf_vector_sum(tf_vector_scaled(c, r), s, tf_vector_cross(axis, r));
    return tf_vector_sum(in_plane, along, axis);
}

//: Hold a rigid element
/// With all components that the plane does not have set to zero.
typedef struct rigid_element {
    int vertices;
    tf_vector center, velocity, rotation;
    tf_vector arm[TF_VERTICES]; ///< of each vertex, from the center, at t = 0
    double reach;               ///< the length of the longest
} rigid_element;

//: Take a rigid element
static rigid_element rigid_of(int axes, const tf_rigid_body *body, int vertices)
{
    rigid_element taken = {.vertices = vertices};
    for (int k = 0; k < axes; k++) {
        taken.center.x[k] = body->center[k];
        taken.velocity.x[k] = body->velocity[k];
        for (int i = 0; i < vertices; i++)
            taken.arm[i].x[k] = body->vertices[axes * i + k] - body->center[k];
    }
    for (int k = axes == 2 ? 2 : 0; k < TF_AXES; k++)
        taken.rotation.x[k] = body->rotation[k];
    for (int i = 0; i < vertices; i++)
        taken.reach = fmax(taken.reach, tf_vector_length(taken.arm[i]));
    return taken;
}

//: Find the position of a rigid vertex
static tf_vector position_of(const rigid_element *body, int vertex, double time)
{
    tf_vector arm = turned(body->rotation, time, body->arm[vertex]);
    tf_vector center = tf_vector_sum(body->center, time, body->velocity);
    return tf_vector_sum(center, 1, arm);
}

//: Find the positions of two rigid elements
static void rigid_positions(const void *motion, double time, tf_vector x[])
{
    const rigid_element *body = motion;
    for (int b = 0, count = 0; b < 2; b++)
        for (int i = 0; i < body[b].vertices; i++)
            x[count++] = position_of(&body[b], i, time);
}

//: Bound the speed of approach
/// A vertex turns toward the normal at no more than |normal x rotation| times
/// its distance from the center.
static double turning_speed(const rigid_element *body, tf_vector normal)
{
    return tf_vector_length(tf_vector_cross(normal, body->rotation)) *
           body->reach;
}

static double rigid_speed(const void *motion, double time, const tf_vector x[],
                          const tf_point_pair *nearest)
{
    (void)time;
    const rigid_element *body = motion;
    tf_vector normal = {{0}};
    int first = body[0].vertices, count = first + body[1].vertices;
    for (int i = 0; i < count; i++) {
        double part = i < first ? -nearest->weight[i] : nearest->weight[i];
        normal = tf_vector_sum(normal, part, x[i]);
    }
    double length = tf_vector_length(normal);
    normal = tf_vector_scaled(length > 0 ? 1 / length : 0, normal);
    tf_vector toward = tf_vector_difference(body[0].velocity, body[1].velocity);
    return tf_vector_dot(toward, normal) + turning_speed(&body[0], normal) +
           turning_speed(&body[1], normal);
}

//: Check a rigid body
static bool all_finite(int count, const double number[])
{
    for (int i = 0; i < count; i++)
        if (!isfinite(number[i]))
            return false;
    return true;
}

static bool body_is_finite(int axes, int vertices, const tf_rigid_body *body)
{
    int from = axes == 2 ? 2 : 0;
    return all_finite(axes * vertices, body->vertices) &&
           all_finite(axes, body->center) && all_finite(axes, body->velocity) &&
           all_finite(TF_AXES - from, body->rotation + from);
}

//: Tell where a rigid vertex is
tf_status tf_rigid_position(int axes, const tf_rigid_body *body, int vertex,
                            double time, double x[])
{
    TF_REQUIRE(body && body->vertices && x);
    if (axes != 2 && axes != 3)
        return TF_BAD_AXES;
    if (vertex < 0)
        return TF_BAD_INDEX;
    tf_rigid_body one = *body;
    one.vertices = body->vertices + (ptrdiff_t)axes * vertex;
    if (!body_is_finite(axes, 1, &one) || !isfinite(time))
        return TF_NOT_FINITE;
    rigid_element taken = rigid_of(axes, &one, 1);
    tf_vector moved = position_of(&taken, 0, time);
    for (int k = 0; k < axes; k++)
        x[k] = moved.x[k];
    return TF_OK;
}

//: Advance two rigid elements
static tf_status advance_bodies(const tf_advance_limits *limits, int axes,
                                int vertices, const tf_rigid_body *first,
                                int others, const tf_rigid_body *second,
                                tf_advancement *advancement)
{
    TF_REQUIRE(limits && first && second && advancement);
    TF_REQUIRE(first->vertices && second->vertices);
    if (!tf_environment_is_ieee())
        return TF_BAD_ENVIRONMENT;
    if (!tf_advance_limits_valid(limits))
        return TF_BAD_OPTION;
    if (!body_is_finite(axes, vertices, first) ||
        !body_is_finite(axes, others, second))
        return TF_NOT_FINITE;
    rigid_element body[] = {rigid_of(axes, first, vertices),
                            rigid_of(axes, second, others)};
    tf_approach approach = {.motion = body,
                            .vertices = vertices,
                            .others = others,
                            .positions = rigid_positions,
                            .speed = rigid_speed};
    *advancement = tf_advance(limits, &approach);
    return TF_OK;
}

//: Advance rigid triangles, or a point and an edge
tf_status tf_advance_triangles(const tf_advance_limits *limits,
                               const tf_rigid_body *first,
                               const tf_rigid_body *second,
                               tf_advancement *advancement)
{
    return advance_bodies(limits, 3, 3, first, 3, second, advancement);
}

tf_status tf_advance_point_edge(const tf_advance_limits *limits,
                                const tf_rigid_body *point,
                                const tf_rigid_body *edge,
                                tf_advancement *advancement)
{
    return advance_bodies(limits, 2, 1, point, 2, edge, advancement);
}
