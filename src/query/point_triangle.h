//: Declare the point-triangle query
#pragma once

#include "base/api.h"

#include "arithmetic/arithmetic.h"
#include "base/status.h"
#include "query/contact.h"
#include "query/motion.h"

/// @addtogroup queries
/// @{

/// Whether, when and how a moving point first meets a moving triangle in space.
/// Thread-safe.
///
/// Touching counts: elements that touch at the start meet at t = 0, at rest or
/// not.  Degenerate cases are covered: a triangle without area is an edge or a
/// point; if all motion is within one plane, the time is the first at which the
/// two meet there.
///
/// @param arithmetic what finds the signs, tf_exact for example
/// @param motion the vertices, 3 coordinates each
/// @param point the index of the point
/// @param triangle the indices of the triangle's vertices, in the order that
///     its normal follows
/// @param[out] contact the answer; set only with TF_OK
/// @return TF_OK; TF_BAD_AXES; TF_BAD_COUNT; TF_BAD_INDEX unless the four
///     indices are distinct and name vertices of the scene; TF_NOT_FINITE;
///     TF_OUT_OF_RANGE; or TF_BAD_ENVIRONMENT
TF_API tf_status tf_point_triangle(const tf_arithmetic *arithmetic,
                                   const tf_motion *motion, int point,
                                   const int triangle[3], tf_contact *contact);

/// @}
