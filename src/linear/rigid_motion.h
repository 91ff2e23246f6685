//: Declare a rigid body
#pragma once

#include "base/api.h"

#include "base/status.h"
#include "linear/advancement.h"

/// @addtogroup study
/// @{

/// An element that moves rigidly: it turns about a center at constant angular
/// velocity, while the center moves at constant velocity.
typedef struct tf_rigid_body {
    const double *vertices; ///< coordinates at t = 0, three a vertex in space,
                            ///< two in the plane; borrowed
    double center[3];       ///< at t = 0
    double velocity[3];     ///< of the center, in units of length per step
    double rotation[3];     ///< the axis times the angle, in radians per step;
                            ///< in the plane rotation[2] alone is read
} tf_rigid_body;

/// Where a vertex of a rigid body is at a time.  Thread-safe.
/// @param axes 2 for a body in the plane, 3 for one in space
/// @param body the body
/// @param vertex the index of the vertex in its list
/// @param time the time, from 0 to 1
/// @param[out] x its `axes` coordinates, correct up to rounding; set only with
///     TF_OK
/// @return TF_OK; TF_BAD_AXES; TF_BAD_INDEX if the index is negative; or
///     TF_NOT_FINITE
TF_API tf_status tf_rigid_position(int axes, const tf_rigid_body *body,
                                   int vertex, double time, double x[]);

//: Declare the advancement of two rigid triangles
/// When two rigid triangles come within a distance of each other.  Thread-safe.
///
/// Conservative advancement: the elements are advanced by their distance over a
/// bound on the speed at which they can approach each other, again and again.
/// The bound is (v1 - v2) . n + |n x w1| r1 + |n x w2| r2 with the velocities
/// v, the angular velocities w, the greatest distances r of a vertex from its
/// center, and the direction n from the first element's nearest point to the
/// second's.  See Mirtich, "Impulse-based dynamic simulation of rigid body
/// systems" (1996), and Zhang, Lee and Kim, "Interactive continuous collision
/// detection for non-convex polyhedra" (2006).  Triangles that intersect are at
/// distance 0.
///
/// @param limits when to end
/// @param first a triangle in space
/// @param second another
/// @param[out] advancement the answer; set only with TF_OK
/// @return TF_OK; TF_BAD_OPTION if the limits are not in their ranges;
///     TF_NOT_FINITE; or TF_BAD_ENVIRONMENT
TF_API tf_status tf_advance_triangles(const tf_advance_limits *limits,
                                      const tf_rigid_body *first,
                                      const tf_rigid_body *second,
                                      tf_advancement *advancement);

//: Declare the advancement of a rigid point and edge
/// The same for a point and an edge in the plane.
/// @param limits when to end
/// @param point a body of one vertex in the plane
/// @param edge a body of two vertices in the plane
/// @param[out] advancement the answer; set only with TF_OK
/// @return as tf_advance_triangles
TF_API tf_status tf_advance_point_edge(const tf_advance_limits *limits,
                                       const tf_rigid_body *point,
                                       const tf_rigid_body *edge,
                                       tf_advancement *advancement);

/// @}
