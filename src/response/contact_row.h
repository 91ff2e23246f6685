//: Declare the row of a contact
#pragma once

#include "response/row.h"
#include "response/step.h"
#include "surface/detect.h"

/// How contacts become rows.
typedef struct tf_row_rule {
    double separation;  ///< pairs that meet and start nearer than this are
                        ///< pushed apart
    double restitution; ///< 0 to 1
    const double *base; ///< the ends from which the response sets out;
                        ///< restitution returns a part of their approach
} tf_row_rule;

/// Makes the row of a contact, with the numbers that its vertices have in the
/// step.  If the row of the point of contact is no good, or if `by_pivots`, it
/// is the row of the contact's two pivots, as far as they have one.  Sets
/// `*gap` to the distance between the points, or the pivots, at the start,
/// along the row's normal.
tf_row tf_row_of_contact(const tf_step *step, const tf_surface_contact *contact,
                         const tf_row_rule *rule, bool by_pivots, double *gap);
