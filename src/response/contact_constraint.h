//: Declare the constraint of a contact
#pragma once

#include "response/constraint.h"
#include "response/step.h"
#include "surface/contacts.h"

/// How contacts become constraints.
typedef struct tf_contact_rule {
    double separation;  ///< pairs that meet and start nearer than this are
                        ///< pushed apart
    double restitution; ///< 0 to 1
    const double *base; ///< the ends from which the response sets out;
                        ///< restitution returns a part of their approach
} tf_contact_rule;

/// The constraint of the two points of a contact as it is, to be listed and not
/// to be solved: along its own normal, if it has one, turned such that the
/// elements do not move apart along it, and without a bound.
tf_constraint tf_contact_points(const tf_surface_contact *contact);

/// Makes the constraint of a contact, with the numbers that its vertices have
/// in the step.  If the constraint of the point of contact is no good, or if
/// `by_pivots`, it is the constraint of the contact's two pivots, as far as
/// they have one.  Sets `*gap` to the distance between the points, or the
/// pivots, at the start, along the constraint's normal.
tf_constraint tf_contact_constraint(const tf_step *step,
                                    const tf_surface_contact *contact,
                                    const tf_contact_rule *rule, bool by_pivots,
                                    double *gap);
