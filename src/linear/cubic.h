//: Declare the cubic of a point and a triangle
#pragma once

#include "base/api.h"

#include "base/status.h"
#include "linear/tolerances.h"
#include "query/contact.h"
#include "query/motion.h"

/// @addtogroup study
/// @{

/// When a moving point and a moving triangle first touch, if every point of
/// the triangle moves in a straight line: a root of the cubic in time that is
/// zero where the four vertices lie in one plane, then a test of proximity.
/// Thread-safe.
///
/// Everything is rounded: verdicts near the border of the tolerances may be
/// wrong, either way.  In the answer `toi_lo` = `toi_hi` is the rounded time;
/// the normal is that of the triangle at this time, or zero if it has no area
/// then; the velocity is that of the point relative to the point of the
/// triangle that it touches; the classification is as that of
/// tf_quadratic_point_edge.
///
/// @param tolerances what counts as touching
/// @param motion the vertices, 3 coordinates each
/// @param point the index of the point
/// @param triangle the indices of the triangle's vertices, in the order that
///     its normal follows
/// @param[out] contact the answer, TF_APART or TF_HIT; set only with TF_OK
/// @return TF_OK; TF_BAD_OPTION; TF_BAD_AXES; TF_BAD_COUNT; TF_BAD_INDEX unless
///     the four indices are distinct and name vertices of the scene;
///     TF_NOT_FINITE; or TF_BAD_ENVIRONMENT
TF_API tf_status tf_cubic_point_triangle(const tf_tolerances *tolerances,
                                         const tf_motion *motion, int point,
                                         const int triangle[3],
                                         tf_contact *contact);

//: Declare the cubic of two edges
/// When two moving edges in space first touch, if every point of them moves in
/// a straight line.  As tf_cubic_point_triangle; the normal is first x second
/// at the time of contact, or zero if the edges are parallel then.
///
/// @param tolerances what counts as touching
/// @param motion the vertices, 3 coordinates each
/// @param first the indices of the first edge's vertices
/// @param second the indices of the second edge's vertices
/// @param[out] contact the answer, TF_APART or TF_HIT; set only with TF_OK
/// @return TF_OK; TF_BAD_OPTION; TF_BAD_AXES; TF_BAD_COUNT; TF_BAD_INDEX unless
///     the four indices are distinct and name vertices of the scene;
///     TF_NOT_FINITE; or TF_BAD_ENVIRONMENT
TF_API tf_status tf_cubic_edge_edge(const tf_tolerances *tolerances,
                                    const tf_motion *motion, const int first[2],
                                    const int second[2], tf_contact *contact);

/// @}
