//: Declare the additive advancement of a point and an edge
#pragma once

#include "base/api.h"

#include "base/status.h"
#include "linear/advancement.h"
#include "query/contact.h"
#include "query/motion.h"

/// @addtogroup study
/// @{

/// When a moving point and a moving edge in the plane come within a distance of
/// each other, if every point of the edge moves in a straight line.
/// Thread-safe.
///
/// Additive advancement: as conservative advancement, with elements that
/// deform.  The bound on the speed at which they can approach each other is the
/// greatest displacement of a vertex of the first element plus that of the
/// second, after their mean is taken from all.  See Li, Kaufman and Jiang,
/// "Codimensional incremental potential contact" (2021), section 6.
///
/// In `contact` both bounds of the time are the time reached, which is not
/// after the true contact; the rest is the answer of the cubic at that time for
/// the points that are nearest then, with the classification TF_TOUCHING.  A
/// verdict TF_UNDECIDED is described in the same way.
///
/// @param limits when to end
/// @param motion the vertices, 2 coordinates each
/// @param point the index of the point
/// @param edge the indices of the edge's vertices
/// @param[out] contact the contact; set only with TF_OK
/// @param[out] advancement how it was found; set only with TF_OK; may be null
/// @return TF_OK; TF_BAD_OPTION if the limits are not in their ranges;
///     TF_BAD_AXES; TF_BAD_COUNT; TF_BAD_INDEX unless the indices are distinct
///     and name vertices of the scene; TF_NOT_FINITE; or TF_BAD_ENVIRONMENT
TF_API tf_status tf_additive_point_edge(const tf_advance_limits *limits,
                                        const tf_motion *motion, int point,
                                        const int edge[2], tf_contact *contact,
                                        tf_advancement *advancement);

//: Declare additive advancement in space
/// The same for a point and a triangle in space.
/// @param limits when to end
/// @param motion the vertices, 3 coordinates each
/// @param point the index of the point
/// @param triangle the indices of the triangle's vertices, in the order that
///     its normal follows
/// @param[out] contact the contact; set only with TF_OK
/// @param[out] advancement how it was found; set only with TF_OK; may be null
/// @return as tf_additive_point_edge
TF_API tf_status tf_additive_point_triangle(const tf_advance_limits *limits,
                                            const tf_motion *motion, int point,
                                            const int triangle[3],
                                            tf_contact *contact,
                                            tf_advancement *advancement);

/// The same for two edges in space.
/// @param limits when to end
/// @param motion the vertices, 3 coordinates each
/// @param first the indices of the first edge's vertices
/// @param second the indices of the second edge's vertices
/// @param[out] contact the contact; set only with TF_OK
/// @param[out] advancement how it was found; set only with TF_OK; may be null
/// @return as tf_additive_point_edge
TF_API tf_status tf_additive_edge_edge(const tf_advance_limits *limits,
                                       const tf_motion *motion,
                                       const int first[2], const int second[2],
                                       tf_contact *contact,
                                       tf_advancement *advancement);

/// @}
