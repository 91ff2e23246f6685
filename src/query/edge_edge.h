//: Declare the edge-edge query
#pragma once

#include "base/api.h"

#include "arithmetic/arithmetic.h"
#include "base/status.h"
#include "query/contact.h"
#include "query/motion.h"

/// @addtogroup queries
/// @{

/// Whether, when and how two moving edges first meet in space.  Thread-safe.
///
/// Touching counts: elements that touch at the start meet at t = 0, at rest or
/// not.  Degenerate cases are covered: an edge without length is a point; if
/// all motion is within one plane or line, the time is the first at which the
/// two meet there.  The normal is zero where the pieces of the bent edges
/// that meet are parallel, or where one has no length.
///
/// @param arithmetic what finds the signs, tf_exact for example
/// @param motion the vertices, 3 coordinates each
/// @param first the indices of the first edge's vertices
/// @param second the indices of the second edge's vertices
/// @param[out] contact the answer; set only with TF_OK
/// @return TF_OK; TF_BAD_AXES; TF_BAD_COUNT; TF_BAD_INDEX unless the four
///     indices are distinct and name vertices of the scene; TF_NOT_FINITE;
///     TF_OUT_OF_RANGE; or TF_BAD_ENVIRONMENT
TF_API tf_status tf_edge_edge(const tf_arithmetic *arithmetic,
                              const tf_motion *motion, const int first[2],
                              const int second[2], tf_contact *contact);

/// @}
