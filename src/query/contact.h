//: Declare a contact
#pragma once

#include "base/api.h"
#include "intersect/verdict.h"

/// @addtogroup contacts
/// @{

/// What a query finds.  Where the verdict is TF_APART everything else is zero.
/// The verdict and the times are those of the query; the rest describes the
/// pair of simplices that may be the first to touch, which tf_clamped may have
/// left undecided even if the verdict is TF_HIT.
///
/// `normal` is the cross product of the edges that the two pieces of the
/// elements in contact have at the start and at the end of the step (in the
/// plane: the edge, turned left by 90 degrees), scaled to length 1: for a point
/// and a triangle it follows the triangle's orientation, for two edges it is
/// first x second.  It is zero where those edges are dependent (an edge of no
/// length, two parallel edges, a triangle of no area) and where a rounded
/// arithmetic overflows.
typedef struct tf_contact {
    tf_verdict verdict;               ///< whether the elements meet
    tf_classification classification; ///< how the contact was found
    double toi_lo; ///< a lower bound of the earliest time of contact, 0 to 1
    double toi_hi; ///< an upper bound of it, 0 to 1; with exact arithmetics at
                   ///< most 2^-50 above the lower one
    double barycentric[2][3]; ///< of the contact in the first and the second
                              ///< element, by their vertices as given: each
                              ///< at least 0, the sum of each element's 1 up
                              ///< to rounding; unused ones are zero
    double normal[3];   ///< of length 1, or zero; `normal[2]` is 0 in the plane
    double velocity[3]; ///< of the first element relative to the second, in
                        ///< units of length per step
    double normal_velocity; ///< `velocity` along `normal`, limited to
                            ///< `DBL_MAX` in absolute value
    int pivot[2]; ///< the vertices whose velocities differ by `velocity`: the
                  ///< index of one in the first and of one in the second
                  ///< element, as given; 0 in linear motion
} tf_contact;

/// @}
