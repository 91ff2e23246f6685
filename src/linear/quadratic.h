//: Declare the quadratic
#pragma once

#include "base/api.h"

#include "base/status.h"
#include "linear/tolerances.h"
#include "query/contact.h"
#include "query/motion.h"

/// @addtogroup study
/// @{

/// When a moving point and a moving edge in the plane first touch, if every
/// point of the edge moves in a straight line: a root of the quadratic in time
/// that is zero where the three vertices lie on one line, then a test of
/// proximity.  Thread-safe.
///
/// Everything is rounded: verdicts near the border of the tolerances may be
/// wrong, either way.  In the answer `toi_lo` = `toi_hi` is the rounded time;
/// the normal is that of the edge at this time, turned left by 90 degrees, or
/// zero if it has no length then; the velocity is that of the point relative
/// to the point of the edge that it touches.  The contact is TF_GENERIC at a
/// root by the barycentric coordinates alone, TF_DEGENERATE if the polynomial
/// is zero (then all times count as roots, and only the ends of the step are
/// examined), else TF_TOUCHING.
///
/// @param tolerances what counts as touching
/// @param motion the vertices, 2 coordinates each
/// @param point the index of the point
/// @param edge the indices of the edge's vertices
/// @param[out] contact the answer, TF_APART or TF_HIT; set only with TF_OK
/// @return TF_OK; TF_BAD_OPTION; TF_BAD_AXES; TF_BAD_COUNT; TF_BAD_INDEX unless
///     the three indices are distinct and name vertices of the scene;
///     TF_NOT_FINITE; or TF_BAD_ENVIRONMENT
TF_API tf_status tf_quadratic_point_edge(const tf_tolerances *tolerances,
                                         const tf_motion *motion, int point,
                                         const int edge[2],
                                         tf_contact *contact);

/// @}
